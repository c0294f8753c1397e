use crate::error::RouteError;
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{Circle, Scene};

/// The poses between which a centerline is planned.
pub(crate) struct Itinerary {
    pub start: Pose,
    /// Centers of the circles in visiting order.
    pub goals: Vec<Point>,
    pub end: Pose,
}

impl Itinerary {
    pub fn new(circles: &[Circle], scene: &Scene, order: &[usize]) -> Result<Self, RouteError> {
        check_order(order, circles.len())?;
        Ok(Self {
            start: Pose::at(scene.start.midpoint(), scene.start.normal_heading()),
            goals: order.iter().map(|&i| circles[i].center).collect(),
            end: Pose::at(scene.end.midpoint(), scene.end.normal_heading()),
        })
    }
}

/// A visiting order names every circle once.
pub(crate) fn check_order(order: &[usize], circles: usize) -> Result<(), RouteError> {
    let mut times = vec![0; circles];
    for &index in order {
        match times.get_mut(index) {
            Some(t) => *t += 1,
            None => {
                return Err(RouteError::BadOrder {
                    index,
                    times: 1,
                    circles,
                });
            }
        }
    }
    match times.iter().position(|&t| t != 1) {
        Some(index) => Err(RouteError::BadOrder {
            index,
            times: times[index],
            circles,
        }),
        None => Ok(()),
    }
}
