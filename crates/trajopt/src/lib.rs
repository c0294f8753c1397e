//! Joint trajectory optimisation of a robot pair and its net length.
