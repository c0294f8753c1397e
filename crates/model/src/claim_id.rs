use std::fmt;

/// The claims of a certificate, in the order of the file format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum ClaimId {
    /// The plan is for this scene.
    Scene,
    /// The net is as long as the scene says, unless overridden.
    NetLength,
    /// First and last poses are the scene's.
    Endpoints,
    /// The distance covered in a step is bounded.
    Step,
    /// The heading change in a step is bounded.
    Turn,
    /// Robots drive forward.
    Forward,
    /// Robots move along their headings.
    NoSidewaysSlip,
    /// Wheel speeds and turning rates are bounded.
    Speed,
    /// Headings stay close to the normal of the line between the robots.
    Abreast,
    /// Robots keep off obstacles.
    RobotClearance,
    /// Robots keep off objects.
    RobotsMissObjects,
    /// The line between the robots sweeps over no obstacle.
    NetEnclosesNoObstacle,
    /// The line between the robots sweeps over every object.
    EveryObjectCovered,
    /// The distance between the axles is bounded from both sides.
    Separation,
    /// The net reaches from hitch to hitch.
    NetReach,
    /// Axle centers stay inside the area.
    InsideArea,
    /// The robots' bodies do not overlap. Only of robots with a body: `Separation` says it of the others.
    RobotsApart,
}

impl ClaimId {
    /// All claims, in the order of the file format.
    pub const ALL: [Self; 17] = [
        Self::Scene,
        Self::NetLength,
        Self::Endpoints,
        Self::Step,
        Self::Turn,
        Self::Forward,
        Self::NoSidewaysSlip,
        Self::Speed,
        Self::Abreast,
        Self::RobotClearance,
        Self::RobotsMissObjects,
        Self::NetEnclosesNoObstacle,
        Self::EveryObjectCovered,
        Self::Separation,
        Self::NetReach,
        Self::InsideArea,
        Self::RobotsApart,
    ];

    /// The name in the file format.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Scene => "scene",
            Self::NetLength => "net_length",
            Self::Endpoints => "endpoints",
            Self::Step => "step",
            Self::Turn => "turn",
            Self::Forward => "forward",
            Self::NoSidewaysSlip => "no_sideways_slip",
            Self::Speed => "speed",
            Self::Abreast => "abreast",
            Self::RobotClearance => "robot_clearance",
            Self::RobotsMissObjects => "robots_miss_objects",
            Self::NetEnclosesNoObstacle => "net_encloses_no_obstacle",
            Self::EveryObjectCovered => "every_object_covered",
            Self::Separation => "separation",
            Self::NetReach => "net_reach",
            Self::InsideArea => "inside_area",
            Self::RobotsApart => "robots_apart",
        }
    }

    /// The unit of the margin; empty when it has none.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Scene => "",
            Self::Turn | Self::Abreast => "rad",
            Self::Speed => "m/s",
            Self::NetLength
            | Self::Endpoints
            | Self::Step
            | Self::Forward
            | Self::NoSidewaysSlip
            | Self::RobotClearance
            | Self::RobotsMissObjects
            | Self::NetEnclosesNoObstacle
            | Self::EveryObjectCovered
            | Self::Separation
            | Self::NetReach
            | Self::InsideArea
            | Self::RobotsApart => "m",
        }
    }

    /// What the claim says, in a short sentence.
    pub const fn meaning(self) -> &'static str {
        match self {
            Self::Scene => "the plan is for this very scene",
            Self::NetLength => "the net is as long as the scene says, unless overridden",
            Self::Endpoints => "first and last poses are the scene's",
            Self::Step => "no step is longer than the greatest step",
            Self::Turn => "no heading changes by more than the greatest turn in a step",
            Self::Forward => "robots drive forward only",
            Self::NoSidewaysSlip => "robots move along their headings",
            Self::Speed => "wheels and turning stay within the robot's limits",
            Self::Abreast => "robots face across the line between them",
            Self::RobotClearance => "no robot touches an obstacle",
            Self::RobotsMissObjects => "no robot touches an object",
            Self::NetEnclosesNoObstacle => "the line between the robots sweeps over no obstacle",
            Self::EveryObjectCovered => "the line between the robots sweeps over every object",
            Self::Separation => "robots neither touch nor overstretch the net",
            Self::NetReach => "the net reaches from hitch to hitch",
            Self::InsideArea => "robot centers stay inside the area",
            Self::RobotsApart => "the robots' bodies do not touch each other",
        }
    }

    /// What helps most often when no plan meets the claim.
    pub const fn remedy(self) -> &'static str {
        match self {
            Self::Scene => "plan again for the scene as it is now",
            Self::NetLength => "plan again with this net, or correct net.length",
            Self::Endpoints
            | Self::Step
            | Self::Turn
            | Self::Forward
            | Self::NoSidewaysSlip
            | Self::Speed => "give more waypoints, or ends whose headings leave room to turn",
            Self::Abreast => {
                "raise planner.max_skew, or give ends at which the robots stand abreast"
            }
            Self::RobotClearance | Self::NetEnclosesNoObstacle | Self::InsideArea => {
                "widen the passage there, or lower robot.radius or give robot.body if the robot is smaller"
            }
            Self::RobotsMissObjects | Self::EveryObjectCovered => {
                "give a longer net, another order (--order given), or move the object away from obstacles"
            }
            Self::RobotsApart => {
                "give ends at which the robots stand farther apart, or a body of circles that fit the robot more closely"
            }
            Self::Separation | Self::NetReach => {
                "give a longer net (--net-length auto finds one), or ends closer together"
            }
        }
    }
}

impl fmt::Display for ClaimId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_lists_every_claim_in_order() {
        assert!(ClaimId::ALL.is_sorted());
        assert_eq!(ClaimId::ALL[16], ClaimId::RobotsApart);
        let mut names = ClaimId::ALL.map(ClaimId::name);
        names.sort_unstable();
        assert!(names.windows(2).all(|w| w[0] != w[1]));
    }
}
