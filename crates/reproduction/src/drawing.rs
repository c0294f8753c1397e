//! What pictures of experiments have in common.

use pairtrawl::geometry::{Point, Pose};
use pairtrawl::model::{ControlSample, Scene};
use pairtrawl::report::study::{Pen, Picture, Track};
use pairtrawl::summarize_scene;

/// A picture of all of a scene, without tracks.
pub(crate) fn whole(scene: &Scene, title: &str) -> Picture {
    Picture {
        title: title.to_owned(),
        scene: summarize_scene(scene, None, None),
        window: None,
        washes: Vec::new(),
        tracks: Vec::new(),
        notes: Vec::new(),
        caption: String::new(),
    }
}

/// The positions of poses.
pub(crate) fn points(poses: &[Pose]) -> Vec<Point> {
    poses.iter().map(|pose| pose.position()).collect()
}

/// A line through places.
pub(crate) fn track(points: Vec<Point>, pen: Pen, name: &str) -> Track {
    Track {
        points,
        pen,
        name: name.to_owned(),
        stops: false,
    }
}

/// Where both robots drove, to a time (s), as two tracks; `stops`: something ended the drive there.
pub(crate) fn driven(
    samples: &[ControlSample],
    until: f64,
    pen: Pen,
    name: &str,
    stops: bool,
) -> [Track; 2] {
    let of = |robot: fn(&ControlSample) -> Pose| Track {
        points: (samples.iter())
            .take_while(|s| s.time <= until)
            .map(|s| robot(s).position())
            .collect(),
        pen,
        name: name.to_owned(),
        stops,
    };
    [of(|s| s.robots.left), of(|s| s.robots.right)]
}
