//! Occupancy grid, signed distance field, object circles and ROS maps.
//!
//! [`World::new`] turns a scene into what the planning stages ask of the space around the robots. The certificate does not
//! use any of it. Lengths are in units of the scene's length scale ([`pairtrawl_model::Scales`]): the constants in here
//! are those of a machine of the paper's size.

mod bounding_circle;
mod bridges;
mod circles;
mod distance_transform;
mod error;
mod field;
mod grid;
mod lattice;
mod map_rectangles;
mod pieces;
mod polygon;
pub mod ros_map;
mod samples;
mod shape;

pub use bounding_circle::minimum_bounding_circle;
pub use circles::OPEN_NET_LENGTH;
pub use error::WorldError;
pub use field::DistanceField;
pub use grid::{Cell, MAX_CELLS, OccupancyGrid, REACH, grid_size};
pub use lattice::Lattice;
pub use pieces::{convex_cover, footprint_outline, obstacle_pieces};
pub use shape::{overlap, signed_distance};

use pairtrawl_geometry::{Convex, Point};
use pairtrawl_model::{Circle, Scene};
use std::sync::Arc;

/// What the planner knows about the space of a scene.
#[derive(Clone, Debug)]
pub struct World {
    /// The paper's Map.
    pub grid: OccupancyGrid,
    /// Signed distance from obstacles.
    pub field: DistanceField,
    /// r_o: one circle per object that is to be gathered, in the scene's order, margin gamma included.
    pub object_circles: Vec<Circle>,
    /// Circles of close objects merged; for order, centerline and baseline.
    pub circles: Vec<Circle>,
    /// Convex pieces whose union has the boundary of all obstacles and contains no free point; deep inside of a ROS map's
    /// blocked regions it may have holes. From objects that are left, bridges lead to obstacles so near that no robot passes
    /// between.
    pub pieces: Vec<Convex>,
    sampled: lattice::Sampled,
    /// Places that the route keeps away from, since an attempt got stuck there. Neither optimizer nor certificate knows them.
    pub closed: Vec<ClosedPlace>,
}

/// A disc that no route leads through.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClosedPlace {
    /// Its center.
    pub center: Point,
    /// Its radius.
    pub radius: f64,
}

impl World {
    /// Builds the world of a scene; `net_length` is d_max, `None` while it is open.
    ///
    /// # Errors
    /// When the grid would be too large, a size is not positive, a coordinate is not finite, or a polygon is flat.
    pub fn new(scene: &Scene, net_length: Option<f64>) -> Result<Self, WorldError> {
        check(scene, net_length)?;
        let mut pieces = pieces::convex_cover(scene)?;
        pieces.extend(bridges::bridges(scene, &pieces));
        let (grid, owners) = OccupancyGrid::new(scene, &pieces)?;
        let field = DistanceField::new(&grid, &owners, &pieces);
        Ok(Self {
            grid,
            field,
            object_circles: circles::object_circles(scene),
            circles: circles::merged_circles(scene, net_length),
            pieces,
            closed: Vec::new(),
            sampled: lattice::Sampled::default(),
        })
    }

    /// The same world after objects of the scene were marked as left, or unmarked: obstacles stay, circles are made anew.
    #[must_use]
    pub fn with_circles_of(&self, scene: &Scene, net_length: Option<f64>) -> Self {
        Self {
            object_circles: circles::object_circles(scene),
            circles: circles::merged_circles(scene, net_length),
            grid: self.grid.clone(),
            field: self.field.clone(),
            pieces: self.pieces.clone(),
            closed: self.closed.clone(),
            sampled: self.sampled.clone(),
        }
    }

    /// Signed distances at the points of a lattice, in their order.
    pub fn distances_on(&self, lattice: &Lattice) -> Arc<[f64]> {
        self.sampled.on(lattice, &self.field)
    }
}

fn check(scene: &Scene, net_length: Option<f64>) -> Result<(), WorldError> {
    if let Some(value) = net_length
        && !(value.is_finite() && value > 0.0)
    {
        return Err(WorldError::NotPositive {
            name: "the net length",
            value,
        });
    }
    let corners = [
        ("the area's lower left corner", scene.area.min),
        ("the area's upper right corner", scene.area.max),
    ];
    for (name, p) in corners {
        finite(|| name.to_owned(), p)?;
    }
    for (i, object) in scene.objects.iter().enumerate() {
        finite(|| format!("object {i}"), object.position)?;
    }
    for (i, obstacle) in scene.obstacles.iter().enumerate() {
        use pairtrawl_model::Obstacle;
        let name = || format!("obstacle {i}");
        match obstacle {
            Obstacle::Box { min, max } => finite(name, *min).and_then(|()| finite(name, *max))?,
            Obstacle::Polygon(vertices) => vertices.iter().try_for_each(|v| finite(name, *v))?,
            Obstacle::Circle { center, radius } => {
                finite(name, Point::new(center.x + radius, center.y + radius))?
            }
        }
    }
    Ok(())
}

fn finite(name: impl Fn() -> String, p: Point) -> Result<(), WorldError> {
    if p.is_finite() {
        Ok(())
    } else {
        Err(WorldError::NotFinite {
            name: name(),
            x: p.x,
            y: p.y,
        })
    }
}
