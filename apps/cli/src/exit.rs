//! The exit codes of the program.

/// The exit codes, the same for every command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Exit {
    /// Done.
    Done = 0,
    /// A fault of the program.
    Internal = 1,
    /// A bad command line.
    Usage = 2,
    /// A bad input file.
    BadInput = 3,
    /// Proven infeasible.
    Infeasible = 4,
    /// No certified plan within the budget.
    NoPlan = 5,
    /// A checked plan or proof is invalid, or a plan to be driven cannot be proven.
    Invalid = 6,
    /// An execution did not gather everything.
    NotGathered = 7,
    /// A file cannot be read or written for reasons outside it.
    Files = 8,
    /// Interrupted.
    Interrupted = 130,
}

impl Exit {
    /// The number that the shell sees.
    pub fn code(self) -> i32 {
        i32::from(self as u8)
    }

    /// Its name in machine-readable output.
    pub fn name(self) -> &'static str {
        match self {
            Self::Done => "done",
            Self::Internal => "internal",
            Self::Usage => "usage",
            Self::BadInput => "bad_input",
            Self::Infeasible => "infeasible",
            Self::NoPlan => "no_plan",
            Self::Invalid => "invalid",
            Self::NotGathered => "not_gathered",
            Self::Files => "files",
            Self::Interrupted => "interrupted",
        }
    }
}
