//! Cutting simple polygons into convex ones.

use crate::shape::edges;
use earcut::Earcut;
use pairtrawl_geometry::Point;

/// Convex polygons, counter-clockwise and without collinear vertices, whose union is the simple polygon `outline` (in either
/// orientation): triangles by ear cutting, joined across diagonals while they stay convex (Hertel and Mehlhorn). Empty when the polygon is flat.
pub fn convex_parts(outline: &[Point]) -> Vec<Vec<Point>> {
    let outline = counter_clockwise(outline);
    if outline.len() < 3 {
        return Vec::new();
    }
    if is_convex(&outline) {
        return vec![outline];
    }
    let mut corners: Vec<usize> = Vec::new();
    Earcut::new().earcut(outline.iter().map(|p| [p.x, p.y]), &[], &mut corners);
    let mut parts: Vec<Vec<Point>> = corners
        .chunks_exact(3)
        .map(|t| counter_clockwise(&[outline[t[0]], outline[t[1]], outline[t[2]]]))
        .filter(|t| t.len() == 3)
        .collect();
    let mut i = 0;
    while i < parts.len() {
        match (i + 1..parts.len()).find_map(|j| Some((j, joined(&parts[i], &parts[j])?))) {
            Some((j, union)) => {
                parts[i] = union;
                parts.remove(j);
            }
            None => i += 1,
        }
    }
    parts
}

/// Twice the signed area, m^2: positive when counter-clockwise.
fn twice_area(vertices: &[Point]) -> f64 {
    let Some(&base) = vertices.first() else {
        return 0.0;
    };
    edges(vertices)
        .map(|(a, b)| (a - base).cross(b - base))
        .sum()
}

/// The polygon counter-clockwise, without repeated and collinear vertices; fewer than three vertices when it is flat.
fn counter_clockwise(outline: &[Point]) -> Vec<Point> {
    let mut vertices = outline.to_vec();
    if twice_area(&vertices) < 0.0 {
        vertices.reverse();
    }
    while let Some(i) = (0..vertices.len()).find(|&i| is_straight(&vertices, i)) {
        vertices.remove(i);
    }
    vertices
}

fn corner(vertices: &[Point], i: usize) -> (Point, Point) {
    let n = vertices.len();
    (
        vertices[i] - vertices[(i + n - 1) % n],
        vertices[(i + 1) % n] - vertices[i],
    )
}

fn is_straight(vertices: &[Point], i: usize) -> bool {
    let (before, after) = corner(vertices, i);
    before.cross(after).abs() <= 1e-12 * before.norm() * after.norm()
}

fn is_convex(vertices: &[Point]) -> bool {
    (0..vertices.len()).all(|i| {
        let (before, after) = corner(vertices, i);
        before.cross(after) > 0.0
    })
}

/// The union of two convex polygons that share an edge, when it is convex too.
fn joined(a: &[Point], b: &[Point]) -> Option<Vec<Point>> {
    let (n, m) = (a.len(), b.len());
    let (i, j) = (0..n)
        .flat_map(|i| (0..m).map(move |j| (i, j)))
        .find(|&(i, j)| a[i] == b[(j + 1) % m] && a[(i + 1) % n] == b[j])?;
    let union: Vec<Point> = (1..=n)
        .map(|k| a[(i + k) % n])
        .chain((2..m).map(|k| b[(j + k) % m]))
        .collect();
    let union = counter_clockwise(&union);
    is_convex(&union).then_some(union)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn star(radii: &[f64]) -> Vec<Point> {
        let step = std::f64::consts::TAU / radii.len() as f64;
        radii
            .iter()
            .enumerate()
            .map(|(i, r)| Point::new(3.0, -2.0) + Point::unit(i as f64 * step) * *r)
            .collect()
    }

    /// Even-odd rule: a different method than the one under test.
    fn is_inside(outline: &[Point], p: Point) -> bool {
        edges(outline)
            .filter(|(a, b)| {
                (a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x
            })
            .count()
            % 2
            == 1
    }

    proptest! {
        #[test]
        fn parts_are_convex_and_their_union_is_the_polygon(
            radii in prop::collection::vec(0.3..2.0_f64, 3..14), turn_around in any::<bool>(),
            probes in prop::collection::vec((0.5..5.5_f64, -4.5..0.5_f64), 40),
        ) {
            let mut outline = star(&radii);
            if turn_around { outline.reverse(); }
            let parts = convex_parts(&outline);
            prop_assert!(parts.iter().all(|p| is_convex(p)));
            let total: f64 = parts.iter().map(|p| twice_area(p)).sum();
            prop_assert!((total - twice_area(&outline).abs()).abs() < 1e-9);
            for (x, y) in probes {
                let p = Point::new(x, y);
                prop_assert_eq!(parts.iter().any(|part| is_inside(part, p)), is_inside(&outline, p));
            }
        }
    }

    #[test]
    fn collinear_vertices_vanish_and_few_parts_are_made() {
        let square = [
            (0.0, 0.0),
            (1.0, 0.0),
            (2.0, 0.0),
            (2.0, 2.0),
            (0.0, 2.0),
            (0.0, 1.0),
        ]
        .map(|(x, y)| Point::new(x, y));
        assert_eq!(
            convex_parts(&square),
            vec![vec![square[0], square[2], square[3], square[4]]]
        );
        let l = [
            (0.0, 0.0),
            (2.0, 0.0),
            (2.0, 1.0),
            (1.0, 1.0),
            (1.0, 2.0),
            (0.0, 2.0),
        ]
        .map(|(x, y)| Point::new(x, y));
        assert_eq!(convex_parts(&l).len(), 2);
        assert!(convex_parts(&square[..3]).is_empty());
    }
}
