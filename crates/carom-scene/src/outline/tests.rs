//! Readers of outlines.
