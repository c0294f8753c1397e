//! Pages, pictures and tables of plans and runs.
