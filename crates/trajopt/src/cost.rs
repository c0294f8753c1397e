use crate::costs::distance::Distance;
use crate::costs::expansion::Expansion;
use crate::costs::obstacle::obstacle_cost;
use crate::costs::smoothness::Smoothness;
use crate::costs::turning::Turning;
use crate::term::Term;
use pairtrawl_model::{Cost, PairTrajectory, Scene};

/// The paper's J (eq. 10) on a pair of trajectories, literally but for the sign of the outer branch of J_e: J_dist over the
/// steps and J_s over the inner waypoints of both robots, J_e over all waypoints, counted once, J_obs over both robots.
pub fn evaluate(scene: &Scene, pair: &PairTrajectory, net_length: f64) -> Cost {
    let p = &scene.planner;
    let (distance, turning) = (Distance::of(p), Turning::of(p));
    let smoothness = [0, 1, 2].map(|k| Smoothness::of_coordinate(p, k));
    let expansion = Expansion::literal(p, &scene.robot);
    let mut cost = Cost::default();
    for robot in [&pair.left, &pair.right] {
        for w in robot.windows(2) {
            let way = w[0].position().distance(w[1].position());
            cost.distance += distance.value(&[way]) + turning.value(&[w[1].heading - w[0].heading]);
        }
        for w in robot.windows(3) {
            let of = [
                [w[0].x, w[1].x, w[2].x],
                [w[0].y, w[1].y, w[2].y],
                [w[0].heading, w[1].heading, w[2].heading],
            ];
            let bends = smoothness.iter().zip(&of);
            cost.smoothness += bends.map(|(term, z)| term.value(z)).sum::<f64>();
        }
        for q in robot {
            cost.obstacle += p.a3 * obstacle_cost(scene, *q);
        }
    }
    for (l, r) in pair.left.iter().zip(&pair.right) {
        let d = l.position().distance(r.position());
        cost.expansion += expansion.to_the_poles(d, net_length, p.k3);
    }
    cost
}
