//! The state under which nothing slides, by the law of older papers: every one that its conditions allow.

pub(in crate::spatial) mod non_sliding;
