//! Plan, prove, rehearse and execute runs of two robots that tow a net.
