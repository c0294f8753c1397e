use pairtrawl_geometry::Point;

/// Something that can touch something else.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// The (0: left, 1: right) robot.
    Robot(usize),
    /// A link of the net, counted from the left hitch.
    Link(usize),
    /// An object.
    Object(usize),
    /// An obstacle by its index in the setup.
    Obstacle(usize),
}

/// Two parts that push each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch {
    /// One of them.
    pub first: Part,
    /// The other.
    pub second: Part,
    /// Where, m.
    pub place: Point,
    /// Normal force, N.
    pub force: f64,
    /// How deep they overlap, m.
    pub depth: f64,
}
