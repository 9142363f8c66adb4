//! carom-figure
