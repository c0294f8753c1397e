//! Controllers for one robot of the pair, no_std.
