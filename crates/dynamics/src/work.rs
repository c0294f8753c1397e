//! How much work the steps of a world were, and where its time goes.

/// How much work the steps were.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// Steps, those that were divided counted by their parts.
    pub steps: u64,
    /// Linear systems solved.
    pub systems: u64,
    /// Orders of elimination found.
    pub orders: u64,
    /// Products of blocks of three by three in the factors of these systems.
    pub products: u64,
    /// Looks for how far to go along a direction.
    pub looks: u64,
    /// Robots, hinges and objects that took part, summed over the steps.
    pub parts: u64,
    /// Places that were looked at for contact, summed over the steps.
    pub contacts: u64,
    /// Steps that ended above the tolerance.
    pub unconverged: u64,
    /// What each stage took, in the units of the clock; zero without a clock.
    pub times: [u64; Stage::COUNT],
}

/// What a step consists of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Which objects sleep, which pairs are near, where they touch.
    Contacts,
    /// What depends on what, and in which order it is eliminated.
    Order,
    /// Rows of contacts and all that is linear in the velocities.
    Rows,
    /// The matrices of the linear systems.
    Matrices,
    /// Their factors.
    Factors,
    /// Their solutions.
    Solutions,
    /// How far to go along a direction, and what is left over there.
    Searches,
    /// Places and velocities after the step.
    Motion,
}

impl Stage {
    /// How many stages there are.
    pub const COUNT: usize = 8;
    /// All of them, in the order of [`Work::times`].
    pub const ALL: [Self; Self::COUNT] = [
        Self::Contacts,
        Self::Order,
        Self::Rows,
        Self::Matrices,
        Self::Factors,
        Self::Solutions,
        Self::Searches,
        Self::Motion,
    ];
}

/// A clock that the host brings, and when the present stage began.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Stopwatch {
    clock: Option<fn() -> u64>,
    since: u64,
}

impl Stopwatch {
    pub(crate) fn new(clock: fn() -> u64) -> Self {
        Self {
            clock: Some(clock),
            since: clock(),
        }
    }

    /// What went by since the last look is not counted.
    pub(crate) fn start(&mut self) {
        self.since = self.clock.map_or(0, |clock| clock());
    }

    /// What went by since the last look was this stage.
    pub(crate) fn ends(&mut self, stage: Stage, work: &mut Work) {
        if let Some(clock) = self.clock {
            let now = clock();
            work.times[stage as usize] += now - self.since;
            self.since = now;
        }
    }
}
