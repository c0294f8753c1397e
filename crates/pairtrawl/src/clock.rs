/// Seconds since the clock was first read; zero without feature `fs`, since not every platform has a clock.
pub(crate) fn seconds() -> f64 {
    #[cfg(feature = "fs")]
    {
        use std::sync::LazyLock;
        use std::time::Instant;
        static BEGIN: LazyLock<Instant> = LazyLock::new(Instant::now);
        BEGIN.elapsed().as_secs_f64()
    }
    #[cfg(not(feature = "fs"))]
    0.0
}
