use super::values::{name, parse_net_length, parse_seconds, parse_tolerance};
use clap::{Args, ValueEnum};

/// The options that `plan` and `demo` share.
#[derive(Clone, Debug, Args)]
pub struct PlanningArguments {
    /// Length of the net in meters instead of the scene's, or `auto`: the planner chooses it
    #[arg(long, value_name = "L|auto", value_parser = parse_net_length)]
    pub net_length: Option<pairtrawl::NetLength>,

    /// Number of waypoints N instead of one that follows from the path length
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(3..=100_000))]
    pub waypoints: Option<u32>,

    /// Visiting order: the scene's own, or the shortest
    #[arg(long, value_enum, default_value_t = Order::Shortest)]
    pub order: Order,

    /// Optimize once, from the shortest order's baseline, instead of the best of several starts
    #[arg(long)]
    pub no_explore: bool,

    /// How the pair's centerline is searched; left out: hybrid A*, and RRT* when that leads to no plan
    #[arg(long, value_enum)]
    pub centerline: Option<Centerline>,

    /// How the trajectories are optimized
    #[arg(long, value_enum, default_value_t = Method::Joint)]
    pub method: Method,

    /// Polish the plan to this relative KKT residual, from 1e-9 to 1e-3; left out: the cost is within about 1e-4 of the
    /// optimum nearby
    #[arg(long, value_name = "E", value_parser = parse_tolerance)]
    pub tolerance: Option<f64>,

    /// Seed of whatever is random: the centerline by RRT*
    #[arg(long, value_name = "S", default_value_t = 0)]
    pub seed: u64,

    /// Stop after this time in seconds with the certified plan at hand; without one: exit 5, and no plan is written
    #[arg(long, value_name = "S", value_parser = parse_seconds)]
    pub time_limit: Option<f64>,

    /// What to do with objects that cannot be gathered, whatever the scene says: refuse the whole plan, or leave them where
    /// they are and gather the rest
    #[arg(long, value_enum, value_name = "none|unreachable")]
    pub leave: Option<LeaveArgument>,

    /// Do not rehearse the plan in physics
    #[arg(long, conflicts_with = "require_rehearsal")]
    pub no_rehearsal: bool,

    /// Refuse a plan whose rehearsal fails (exit 5)
    #[arg(long)]
    pub require_rehearsal: bool,
}

/// Visiting orders.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum Order {
    /// As the objects stand in the scene
    Given,
    /// The shortest open path
    Shortest,
}

impl PlanningArguments {
    /// The same, as the library takes it.
    pub fn options(&self) -> pairtrawl::PlanOptions {
        use pairtrawl::RehearsalMode;
        pairtrawl::PlanOptions {
            net_length: self.net_length,
            waypoints: self.waypoints.map(|n| n as usize),
            order: self.order.into(),
            explore: !self.no_explore,
            centerline: self.centerline.map(Into::into),
            method: self.method.into(),
            tolerance: self.tolerance,
            seed: self.seed,
            time_limit: self.time_limit.map(std::time::Duration::from_secs_f64),
            leave: self.leave.map(Into::into),
            rehearsal: match (self.no_rehearsal, self.require_rehearsal) {
                (true, _) => RehearsalMode::Skip,
                (false, true) => RehearsalMode::Require,
                (false, false) => RehearsalMode::Report,
            },
            ..pairtrawl::PlanOptions::default()
        }
    }
}

impl PlanningArguments {
    /// The same as words of a command line; what is default is left out.
    pub fn as_arguments(&self) -> Vec<String> {
        // Every field by name: a new one must not be forgotten here.
        let Self {
            net_length,
            waypoints,
            order,
            no_explore,
            centerline,
            method,
            tolerance,
            seed,
            time_limit,
            leave,
            no_rehearsal,
            require_rehearsal,
        } = self;
        let net_length = net_length.map(|length| match length {
            pairtrawl::NetLength::Auto => "auto".to_owned(),
            pairtrawl::NetLength::Fixed(length) => format!("{length:?}"),
        });
        let values = [
            ("--net-length", net_length),
            ("--waypoints", waypoints.map(|n| n.to_string())),
            (
                "--order",
                name(order).filter(|_| !matches!(order, Order::Shortest)),
            ),
            ("--centerline", centerline.as_ref().and_then(name)),
            (
                "--method",
                name(method).filter(|_| !matches!(method, Method::Joint)),
            ),
            ("--tolerance", tolerance.map(|e| format!("{e:?}"))),
            ("--seed", (*seed != 0).then(|| seed.to_string())),
            ("--time-limit", time_limit.map(|s| format!("{s:?}"))),
            ("--leave", leave.as_ref().and_then(name)),
        ];
        let flags = [
            ("--no-explore", no_explore),
            ("--no-rehearsal", no_rehearsal),
            ("--require-rehearsal", require_rehearsal),
        ];
        let values = values.into_iter().filter_map(|(option, value)| {
            let value = value?;
            Some([option.to_owned(), value])
        });
        let flags = flags.into_iter().filter(|(_, is_set)| **is_set);
        values
            .flatten()
            .chain(flags.map(|(option, _)| option.to_owned()))
            .collect()
    }
}

impl From<Order> for pairtrawl::OrderMethod {
    fn from(order: Order) -> Self {
        match order {
            Order::Given => Self::Given,
            Order::Shortest => Self::Shortest,
        }
    }
}

/// What is done with objects that cannot be gathered.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum LeaveArgument {
    /// One that cannot be gathered refuses the whole plan
    None,
    /// They are left where they are, and the rest is gathered
    Unreachable,
}

impl From<LeaveArgument> for pairtrawl::model::Leave {
    fn from(leave: LeaveArgument) -> Self {
        match leave {
            LeaveArgument::None => Self::None,
            LeaveArgument::Unreachable => Self::Unreachable,
        }
    }
}

/// Centerline planners.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum Centerline {
    /// Hybrid A*
    HybridAStar,
    /// Informed RRT*
    RrtStar,
}

impl From<Centerline> for pairtrawl::CenterlineMethod {
    fn from(centerline: Centerline) -> Self {
        match centerline {
            Centerline::HybridAStar => Self::HybridAStar,
            Centerline::RrtStar => Self::RrtStar,
        }
    }
}

/// Ways to optimize.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum Method {
    /// Both robots and the net length at once
    Joint,
    /// Algorithm 1 of the paper: one robot at a time, an open net length first N dL_max
    Alternating,
    /// The same, an open net length first that of the joint method
    AlternatingBounded,
}

impl From<Method> for pairtrawl::Method {
    fn from(method: Method) -> Self {
        match method {
            Method::Joint => Self::Joint,
            Method::Alternating => Self::Alternating,
            Method::AlternatingBounded => Self::AlternatingBounded,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::PlanningArguments;
    use clap::Parser;

    #[derive(Debug, Parser)]
    struct Line {
        #[command(flatten)]
        planning: PlanningArguments,
    }

    #[test]
    fn options_survive_a_command_line() {
        let long = "x --net-length 2.5 --waypoints 300 --order given --no-explore --centerline rrt-star \
                    --method alternating-bounded --tolerance 1e-6 --seed 7 --time-limit 1.5 --leave unreachable --no-rehearsal";
        for line in [
            "x",
            "x --net-length auto --require-rehearsal --leave none",
            long,
        ] {
            let given = Line::parse_from(line.split_whitespace()).planning;
            let words = std::iter::once("x".to_owned()).chain(given.as_arguments());
            let again = Line::parse_from(words).planning;
            assert_eq!(format!("{given:?}"), format!("{again:?}"));
        }
        let words = Line::parse_from(["x"]).planning.as_arguments();
        assert!(words.is_empty(), "{words:?}");
    }
}
