/// Masses, frictions and gravity for rehearsal and execution (`[physics]` of a scene).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(default, deny_unknown_fields)
)]
pub struct PhysicsParameters {
    /// Gravity, m/s^2.
    pub gravity: f64,
    /// Robot mass m, kg.
    pub robot_mass: f64,
    /// Robot inertia about the vertical axis through the center of mass, kg m^2.
    pub robot_inertia: f64,
    /// d: the center of mass lies this far ahead of the axle, m.
    pub center_of_mass: f64,
    /// r: wheel radius, m.
    pub wheel_radius: f64,
    /// Greatest torque of a wheel, N m.
    pub max_torque: f64,
    /// Friction of the tyres, which bounds traction.
    pub wheel_friction: f64,
    /// Net mass per meter, kg/m.
    pub net_mass: f64,
    /// Length of a net link, m; the net has round(length / link) links.
    pub net_link: f64,
    /// Thickness of the net, m.
    pub net_thickness: f64,
    /// Height of the net, m.
    pub net_height: f64,
    /// Damping of a hinge between links, N m s/rad.
    pub hinge_damping: f64,
    /// Friction between net and floor.
    pub net_friction: f64,
    /// Friction between objects and floor.
    pub object_friction: f64,
    /// Friction in contacts of net, objects, robots and obstacles with each other.
    pub contact_friction: f64,
    /// Tension at a hitch above which the net counts as snagged, N.
    pub tension_limit: f64,
}

impl Default for PhysicsParameters {
    fn default() -> Self {
        Self {
            gravity: 9.81,
            robot_mass: 1.43,
            robot_inertia: 0.0146,
            center_of_mass: 0.020,
            wheel_radius: 0.033,
            max_torque: 3.0,
            wheel_friction: 0.8,
            net_mass: 0.02,
            net_link: 0.1,
            net_thickness: 0.01,
            net_height: 0.08,
            hinge_damping: 1e-3,
            net_friction: 0.2,
            object_friction: 0.2,
            contact_friction: 0.2,
            tension_limit: 10.0,
        }
    }
}
