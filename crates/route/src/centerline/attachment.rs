//! Which vertex of a path belongs to which of the goals that it passes in order.

use pairtrawl_geometry::Point;

/// Largest table for the exact attachment; longer paths with more goals are attached one goal after the other.
const MAX_TABLE: usize = 4_000_000;
/// How near a path passes a goal at least, for the search one by one.
const NEAR: f64 = 0.4;
/// How far along the path an attachment may move between two iterations, as a share of the vertices and at least.
const DRIFT: usize = 12;

/// Attachments that follow a path through its small changes.
pub(crate) struct Attachment<'g> {
    goals: &'g [Point],
    /// Attachments and number of vertices of the last path.
    last: Option<(Vec<usize>, usize)>,
}

impl<'g> Attachment<'g> {
    pub fn new(goals: &'g [Point]) -> Self {
        Self { goals, last: None }
    }

    /// The vertex nearest to each goal near the one of the last call; the first call looks everywhere.
    pub fn follow(&mut self, points: &[Point]) -> Vec<usize> {
        let n = points.len();
        let now = match &self.last {
            None => attach(points, self.goals),
            Some((last, before)) => {
                let mut low = 0;
                let near = last.iter().zip(self.goals).map(|(&k, goal)| {
                    let middle = k * n / (*before).max(1);
                    let from = middle.saturating_sub(DRIFT).max(low).min(n - 1);
                    let to = (middle + DRIFT).min(n - 1).max(from);
                    low = nearest(points, *goal, from, to);
                    low
                });
                near.collect()
            }
        };
        self.last = Some((now.clone(), n));
        now
    }
}

fn nearest(points: &[Point], goal: Point, from: usize, to: usize) -> usize {
    let distance = |i: &usize| (points[*i] - goal).norm_squared();
    (from..=to)
        .min_by(|a, b| distance(a).total_cmp(&distance(b)))
        .unwrap_or(from)
}

/// The vertex nearest to each goal with non-decreasing indices, by least sum of squared distances.
pub(crate) fn attach(points: &[Point], goals: &[Point]) -> Vec<usize> {
    let n = points.len();
    if n == 0 {
        return Vec::new();
    }
    if n.saturating_mul(goals.len()) > MAX_TABLE {
        return attach_one_by_one(points, goals);
    }
    // cost[i]: least sum for the goals so far with the last one attached at or before i.
    let mut cost = vec![0.0; n];
    let mut choice: Vec<Vec<u32>> = Vec::with_capacity(goals.len());
    for goal in goals {
        let mut best = f64::INFINITY;
        let mut at = 0u32;
        let mut row = Vec::with_capacity(n);
        for (i, cost) in cost.iter_mut().enumerate() {
            let here = *cost + (points[i] - *goal).norm_squared();
            if here < best {
                best = here;
                at = i as u32;
            }
            *cost = best;
            row.push(at);
        }
        choice.push(row);
    }
    let mut indices = vec![0; goals.len()];
    let mut limit = n - 1;
    for (index, row) in indices.iter_mut().zip(&choice).rev() {
        limit = row[limit] as usize;
        *index = limit;
    }
    indices
}

/// For each goal the nearest vertex of the first stretch behind the last goal's vertex that comes near it.
fn attach_one_by_one(points: &[Point], goals: &[Point]) -> Vec<usize> {
    let n = points.len();
    let mut from = 0;
    goals
        .iter()
        .map(|&goal| {
            let is_near = |i: &usize| points[*i].distance(goal) < NEAR;
            from = match (from..n).find(is_near) {
                Some(first) => {
                    let end = (first..n).find(|i| !is_near(i)).unwrap_or(n);
                    nearest(points, goal, first, end - 1)
                }
                None => nearest(points, goal, from, n - 1),
            };
            from
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn goals_are_attached_in_order_along_a_path_that_comes_back() {
        // There and back along the x axis, 0.1 m apart; the goals lie beside it.
        let points: Vec<Point> = (0..=40)
            .map(|i| {
                Point::new(
                    0.1 * f64::from(if i <= 20 { i } else { 40 - i }),
                    if i <= 20 { 0.0 } else { 0.3 },
                )
            })
            .collect();
        let goals = [
            Point::new(1.5, 0.1),
            Point::new(1.0, 0.2),
            Point::new(0.52, 0.3),
        ];
        assert_eq!(attach(&points, &goals), [15, 30, 35]);
        assert_eq!(attach_one_by_one(&points, &goals)[0], 15);
        let mut follow = Attachment::new(&goals);
        assert_eq!(follow.follow(&points), [15, 30, 35]);
        let moved: Vec<Point> = points.iter().map(|&p| p + Point::new(0.2, 0.0)).collect();
        assert_eq!(follow.follow(&moved), [13, 32, 37]);
    }
}
