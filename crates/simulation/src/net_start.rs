//! How the net lies at the start: a symmetric U behind the hitches; where something is in its way, folded to fit; or as the
//! scene says.
//!
//! The U: link i of n turns against the hitch line by clamp(s (i - (n-1)/2), -90 deg, 90 deg), with the s for which the chain
//! spans the gap: a circular arc for a short net, straight legs and a round bottom for a long one. A fold: the chain goes
//! up and down like an accordion, k links each way, with the slope for which it spans the gap.

use crate::obstacles::FixedShape;
use crate::{Parameters, SimulationError};
use pairtrawl_dynamics::Solid;
use pairtrawl_geometry::{Point, Pose, Segment};
use pairtrawl_model::{Footprint, Object, Scene, Side, Warning};
use std::f64::consts::FRAC_PI_2;

/// A given start shape may end this far from the hitches, in units of the machine.
const HITCH_TOLERANCE: f64 = 0.05;
/// Bisections of a shape parameter; enough for every bit.
const BISECTIONS: usize = 200;

/// Nodes of the net at the start (left hitch, hinges, right hitch), and a warning when it had to be folded or bent.
pub(crate) struct NetStart {
    pub(crate) nodes: Vec<Point>,
    pub(crate) warning: Option<Warning>,
}

/// What a link must not overlap at the start.
pub(crate) struct Surroundings<'a> {
    obstacles: &'a [Solid],
    objects: Vec<Solid>,
    /// The parts of the (left, right) robot.
    robots: [Vec<Solid>; 2],
    /// As many links at each end may lie within the robot that holds them.
    within_body: usize,
    thickness: f64,
    hitches: [Point; 2],
}

/// Chooses the start shape.
pub(crate) fn lay(
    scene: &Scene,
    parameters: &Parameters,
    robots: [Pose; 2],
    obstacles: &[Solid],
) -> Result<NetStart, SimulationError> {
    let hitches = robots.map(|pose| pose.hitch_point(parameters.robot.hitch));
    let net_length = parameters.link_length * parameters.links as f64;
    let gap = (hitches[1] - hitches[0]).norm();
    if gap > net_length * (1.0 + 1e-9) {
        return Err(SimulationError::NetTooShort {
            gap,
            length: net_length,
        });
    }
    if let Some(outline) = &scene.net.start {
        return follow(outline, parameters, hitches);
    }
    let around = Surroundings::new(scene, parameters, robots, hitches, obstacles);
    let u = chain(
        hitches,
        parameters,
        &u_turns(parameters.links, gap / parameters.link_length),
    );
    let overlaps = around.overlaps(&u);
    if overlaps == 0 {
        return Ok(NetStart {
            nodes: u,
            warning: None,
        });
    }
    let mut best = (overlaps, u);
    for links in (1..=parameters.links / 2).rev() {
        for sign in [1.0, -1.0] {
            let turns = fold_turns(parameters.links, links, gap / parameters.link_length, sign);
            let nodes = chain(hitches, parameters, &turns);
            let overlaps = around.overlaps(&nodes);
            if overlaps < best.0 {
                best = (overlaps, nodes);
            }
            if best.0 == 0 {
                return Ok(NetStart {
                    nodes: best.1,
                    warning: Some(Warning::NetFolded),
                });
            }
        }
    }
    let warning = Warning::NetOverlaps {
        overlapping: best.0,
        links: parameters.links,
    };
    Ok(NetStart {
        nodes: best.1,
        warning: Some(warning),
    })
}

/// Turns of the links against the hitch line for a U that spans `span` link lengths.
fn u_turns(links: usize, span: f64) -> Vec<f64> {
    let middle = 0.5 * (links as f64 - 1.0);
    let shape =
        |s: f64| (0..links).map(move |i| (s * (i as f64 - middle)).clamp(-FRAC_PI_2, FRAC_PI_2));
    let (mut low, mut high) = (0.0, 2.0 * FRAC_PI_2);
    for _ in 0..BISECTIONS {
        let s = 0.5 * (low + high);
        let reach: f64 = shape(s).map(libm::cos).sum();
        if reach > span { low = s } else { high = s }
    }
    shape(0.5 * (low + high)).collect()
}

/// Turns of the links of an accordion with `half_period` links each way; the last part folds back only as far as needed to
/// end on the hitch line.
fn fold_turns(links: usize, half_period: usize, span: f64, sign: f64) -> Vec<f64> {
    // As many links up as down: an odd one lies flat in the middle.
    let pairs = links / 2;
    let mut signs = Vec::with_capacity(links);
    let (mut up, mut down) = (pairs, pairs);
    while up + down > 0 {
        // Backwards first.
        let out = half_period.min(up);
        signs.extend(std::iter::repeat_n(-sign, out));
        up -= out;
        let back = out.min(down);
        signs.extend(std::iter::repeat_n(sign, back));
        down -= back;
    }
    if links % 2 == 1 {
        signs.insert(links / 2, 0.0);
    }
    let flat = (links % 2) as f64;
    let slope = libm::acos(((span - flat) / (links as f64 - flat)).clamp(0.0, 1.0));
    signs.into_iter().map(|s| s * slope).collect()
}

/// Node positions from the links' turns against the hitch line; the last node is put on the right hitch exactly.
fn chain(hitches: [Point; 2], parameters: &Parameters, turns: &[f64]) -> Vec<Point> {
    let line = hitches[1] - hitches[0];
    let base = libm::atan2(line.y, line.x);
    let mut nodes = vec![hitches[0]];
    let mut place = hitches[0];
    for turn in turns {
        place += Point::unit(base + turn) * parameters.link_length;
        nodes.push(place);
    }
    close(&mut nodes, hitches, parameters.link_length);
    nodes
}

/// Moves the nodes as little as needed so that both ends lie on the hitches and every link has its length (FABRIK).
fn close(nodes: &mut [Point], hitches: [Point; 2], link: f64) {
    let last = nodes.len() - 1;
    for _ in 0..10_000 {
        if (nodes[last] - hitches[1]).norm() < 1e-12 {
            break;
        }
        nodes[last] = hitches[1];
        for i in (0..last).rev() {
            nodes[i] = toward(nodes[i + 1], nodes[i], link);
        }
        nodes[0] = hitches[0];
        for i in 1..=last {
            nodes[i] = toward(nodes[i - 1], nodes[i], link);
        }
    }
}

fn toward(from: Point, to: Point, distance: f64) -> Point {
    let along = to - from;
    let norm = along.norm();
    if norm > 0.0 {
        from + along * (distance / norm)
    } else {
        from + Point::new(distance, 0.0)
    }
}

/// Lays the chain along a given outline.
fn follow(
    outline: &[Point],
    parameters: &Parameters,
    hitches: [Point; 2],
) -> Result<NetStart, SimulationError> {
    let ends = [outline.first(), outline.last()];
    for ((end, hitch), side) in ends.into_iter().zip(hitches).zip(Side::BOTH) {
        let distance = end.map_or(f64::INFINITY, |&p| (p - hitch).norm());
        if distance > HITCH_TOLERANCE || !distance.is_finite() {
            return Err(SimulationError::NetStart {
                side,
                distance,
                x: hitch.x,
                y: hitch.y,
            });
        }
    }
    let total: f64 = outline.windows(2).map(|s| (s[1] - s[0]).norm()).sum();
    let net_length = parameters.link_length * parameters.links as f64;
    let nodes_at = |fraction: f64| {
        let mut rest = fraction * total;
        for s in outline.windows(2) {
            let segment = (s[1] - s[0]).norm();
            if rest <= segment && segment > 0.0 {
                return s[0].lerp(s[1], rest / segment);
            }
            rest -= segment;
        }
        hitches[1]
    };
    let mut nodes: Vec<Point> = (0..=parameters.links)
        .map(|i| nodes_at(i as f64 / parameters.links as f64))
        .collect();
    nodes[0] = hitches[0];
    for i in 1..nodes.len() {
        nodes[i] = toward(nodes[i - 1], nodes[i], parameters.link_length);
    }
    close(&mut nodes, hitches, parameters.link_length);
    let off = (total - net_length).abs();
    let warning = (off > 0.02 * net_length).then_some(Warning::NetOffStartLine {
        line: total,
        net: net_length,
    });
    Ok(NetStart { nodes, warning })
}

impl<'a> Surroundings<'a> {
    fn new(
        scene: &Scene,
        parameters: &Parameters,
        robots: [Pose; 2],
        hitches: [Point; 2],
        obstacles: &'a [Solid],
    ) -> Self {
        let object = |object: &Object| {
            FixedShape::of(object.footprint, Pose::at(object.position, 0.0)).solid()
        };
        Self {
            obstacles,
            objects: scene.objects.iter().map(object).collect(),
            robots: robots.map(|pose| robot_parts(parameters, pose)),
            within_body: parameters.links_within_body(),
            thickness: parameters.physics.net_thickness,
            hitches,
        }
    }

    /// How many links overlap something. A link at a hitch may touch the robot that holds it.
    fn overlaps(&self, nodes: &[Point]) -> usize {
        nodes
            .windows(2)
            .enumerate()
            .filter(|(i, ends)| self.link_overlaps(*i, [ends[0], ends[1]], nodes.len() - 2))
            .count()
    }

    fn link_overlaps(&self, index: usize, ends: [Point; 2], last: usize) -> bool {
        let within = self.within_body.max(1);
        let at_hitch = |side: Side| {
            let tied = match side {
                Side::Left => index < within,
                Side::Right => index + within > last,
            };
            tied || Segment::new(ends[0], ends[1]).distance(self.hitches[side.index()]) < 1e-9
        };
        let meets = |solids: &[Solid]| solids.iter().any(|s| s.meets_link(ends, self.thickness));
        meets(self.obstacles)
            || meets(&self.objects)
            || Side::BOTH
                .into_iter()
                .any(|side| !at_hitch(side) && meets(&self.robots[side.index()]))
    }
}

/// The parts of a robot at a pose.
fn robot_parts(parameters: &Parameters, pose: Pose) -> Vec<Solid> {
    let (forward, left) = (pose.forward(), pose.forward().perp());
    let part = |(center, footprint): (Point, Footprint)| {
        let place = pose.position() + forward * center.x + left * center.y;
        FixedShape::of(footprint, Pose::at(place, pose.heading)).solid()
    };
    parameters.outline().into_iter().map(part).collect()
}
