/// Watches runs that go on in parallel, and may stop them. `()` watches nothing.
pub trait ExecutionObserver: Sync {
    /// Run `index` is this far, 0 to 1.
    fn progressed(&self, _index: usize, _part: f64) {}

    /// Run `index` is finished.
    fn finished(&self, _index: usize) {}

    /// Asked many times a second: true ends every run under way; finished ones are kept.
    fn interrupted(&self) -> bool {
        false
    }
}

impl ExecutionObserver for () {}
