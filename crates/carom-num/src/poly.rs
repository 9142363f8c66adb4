//! poly
