//! The program `pairtrawl`.
fn main() {}
