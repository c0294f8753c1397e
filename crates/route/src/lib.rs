//! Visiting order, centerline and baseline pair.
