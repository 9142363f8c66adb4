//! Who hears how far long work is.

/// The page, while it waits for an answer.
pub trait Watch: Sync {
    /// A drop was computed.
    fn step(&self) {}

    /// News, as JSON.
    fn told(&self, _news: &str) {}
}

/// Nobody listens.
impl Watch for () {}
