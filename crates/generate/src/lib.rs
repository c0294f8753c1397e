//! Generator of scenes that are solvable by construction.
