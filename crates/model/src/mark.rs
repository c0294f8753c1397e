use pairtrawl_geometry::Point;

/// A place on a map that is to be seen, and why.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// Where, m.
    pub place: Point,
    /// Where a thing at this place would have to be moved at least, m.
    pub toward: Option<Point>,
    /// What there is to see, for people.
    pub text: String,
}
