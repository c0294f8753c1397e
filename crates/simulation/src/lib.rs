//! Robots, net and objects in planar physics.
