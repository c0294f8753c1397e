use pairtrawl_model::Side;

/// Something that can touch something else.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Part {
    /// An obstacle of the scene by its index; `None`: the map's.
    Obstacle(Option<usize>),
    /// A robot.
    Robot(Side),
    /// A link of the net, counted from the left hitch.
    Link(usize),
    /// An object of the scene.
    Object(usize),
}
