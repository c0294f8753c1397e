//! A pair of trajectories from anywhere, judged: claims, cost, separation, and what happens when it is driven.

use pairtrawl::certificate::certify;
use pairtrawl::model::numbers::{length, quantity};
use pairtrawl::model::{Certificate, ClaimId, PairTrajectory, Rehearsal, RehearsalRecord, Scene};
use pairtrawl::rehearse_trajectory;
use pairtrawl::simulation::Options;
use pairtrawl::trajopt::evaluate;

/// What is known about a pair of trajectories.
#[derive(Clone, Debug)]
pub struct Judged {
    /// d_max, m.
    pub net_length: f64,
    /// Driven by both robots together, m.
    pub paths: f64,
    /// The paper's J.
    pub cost: f64,
    /// Least and greatest distance of the robots, m.
    pub separation: [f64; 2],
    /// The claims on poses that are linear between waypoints.
    pub certificate: Certificate,
    /// What happened when it was driven closely with the net; or why it cannot be.
    pub rehearsal: Result<RehearsalRecord, String>,
}

impl Judged {
    /// Judges and drives.
    pub fn of(scene: &Scene, trajectory: &PairTrajectory, net_length: f64) -> Self {
        let (left, right) = trajectory.path_lengths();
        let apart = (0..trajectory.len()).map(|i| trajectory.pair(i).separation());
        let (least, most) = apart.fold((f64::INFINITY, 0.0), |(l, m), d| {
            (f64::min(l, d), f64::max(m, d))
        });
        let options = Options::default();
        let rehearsal = rehearse_trajectory(scene, net_length, trajectory, &options);
        Self {
            net_length,
            paths: left + right,
            cost: evaluate(scene, trajectory, net_length).total(),
            separation: [least, most],
            certificate: certify(scene, net_length, trajectory, None),
            rehearsal: rehearsal.map_err(|error| error.to_string()),
        }
    }

    /// The claims that fail, each with its margin.
    pub fn failing(&self) -> String {
        let failing = self.certificate.claims.iter().filter(|c| !c.holds);
        let words: Vec<String> = failing
            .map(|c| match c.margin.is_finite() {
                true => format!("{} by {}", c.id, quantity(-c.margin, c.id.unit())),
                false => c.id.to_string(),
            })
            .collect();
        if words.is_empty() {
            "none".to_owned()
        } else {
            words.join(", ")
        }
    }

    /// True when this claim holds.
    pub fn holds(&self, id: ClaimId) -> bool {
        self.certificate
            .claims
            .iter()
            .any(|c| c.id == id && c.holds)
    }

    /// How many claims fail.
    pub fn failures(&self) -> usize {
        self.certificate.claims.iter().filter(|c| !c.holds).count()
    }

    /// How near robots come to obstacles and objects beyond their radius, m: negative where they touch.
    pub fn clearance(&self) -> f64 {
        let ids = [ClaimId::RobotClearance, ClaimId::RobotsMissObjects];
        let claims = self
            .certificate
            .claims
            .iter()
            .filter(|c| ids.contains(&c.id));
        claims.map(|c| c.margin).fold(f64::INFINITY, f64::min)
    }

    /// How many objects the rehearsal gathers.
    pub fn gathered(&self) -> usize {
        self.rehearsal
            .as_ref()
            .map_or(0, RehearsalRecord::gathered_count)
    }

    /// What the rehearsal says, in words.
    pub fn driven(&self) -> String {
        match &self.rehearsal {
            Err(why) => format!("cannot be driven: {why}"),
            Ok(record) => {
                let off = record.max_deviation[0].max(record.max_deviation[1]);
                let gathered = format!(
                    "{} of {} gathered, up to {} off",
                    record.gathered_count(),
                    record.wanted(),
                    length(off)
                );
                match &record.verdict {
                    Rehearsal::Failed { event, time, .. } => {
                        format!("{gathered}; first: {event} after {time:.1} s")
                    }
                    _ => gathered,
                }
            }
        }
    }
}
