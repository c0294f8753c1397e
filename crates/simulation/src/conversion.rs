//! SI units outside of the simulation, units of the machine inside: so its physics does not depend on the scale.

use crate::{Contact, RobotDrive, RobotLoad, RobotState, SimulationError};
use pairtrawl_model::Units;

impl RobotDrive {
    /// In units of the machine, from SI units.
    pub(crate) fn in_units(self, units: &Units) -> Self {
        match self {
            Self::Torques { left, right } => Self::Torques {
                left: left / units.torque(),
                right: right / units.torque(),
            },
            Self::Velocity { forward, turn_rate } => Self::Velocity {
                forward: forward / units.speed(),
                turn_rate: turn_rate * units.time,
            },
        }
    }
}

impl RobotState {
    /// In SI units, from units of the machine.
    pub(crate) fn in_si(self, units: &Units) -> Self {
        Self {
            pose: units.pose_in_si(self.pose),
            forward: self.forward * units.speed(),
            sideways: self.sideways * units.speed(),
            turn_rate: self.turn_rate / units.time,
        }
    }
}

impl RobotLoad {
    /// In SI units, from units of the machine.
    pub(crate) fn in_si(self, units: &Units) -> Self {
        Self {
            drive_force: self.drive_force * units.force(),
            torques: self.torques.map(|torque| torque * units.torque()),
            load: self.load * units.force(),
        }
    }
}

impl Contact {
    /// In SI units, from units of the machine.
    pub(crate) fn in_si(self, units: &Units) -> Self {
        Self {
            place: units.place_in_si(self.place),
            depth: self.depth * units.length,
            impulse: self.impulse * units.force() * units.time,
            ..self
        }
    }
}

impl SimulationError {
    /// With its lengths in SI units, from units of the machine.
    pub(crate) fn in_si(self, units: &Units) -> Self {
        let l = units.length;
        match self {
            Self::NetTooShort { gap, length } => Self::NetTooShort {
                gap: gap * l,
                length: length * l,
            },
            Self::NetStart {
                side,
                distance,
                x,
                y,
            } => Self::NetStart {
                side,
                distance: distance * l,
                x: x * l,
                y: y * l,
            },
            Self::Option { .. }
            | Self::Parameter { .. }
            | Self::Polygon { .. }
            | Self::Trajectory { .. }
            | Self::Diverged { .. } => self,
        }
    }
}
