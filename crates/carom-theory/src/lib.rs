//! carom-theory
