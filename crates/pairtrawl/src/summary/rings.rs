use pairtrawl_geometry::Point;
use pairtrawl_model::OccupancyMap;

/// Directions along grid lines, counter-clockwise: +column, +row, -column, -row.
const DIRECTIONS: [(i64, i64); 4] = [(1, 0), (0, 1), (-1, 0), (0, -1)];

/// The boundary of a map's free cells as closed rings in the scene's frame, free cells to the left of the direction of
/// travel; only corners are kept. To be filled by the even-odd rule.
pub(super) fn free_rings(map: &OccupancyMap) -> Vec<Vec<Point>> {
    let mut boundary = Boundary::new(map);
    let mut rings = Vec::new();
    for start in 0..boundary.leaving.len() {
        while let Some(ring) = boundary.take_ring(start) {
            rings.push(
                ring.into_iter()
                    .map(|corner| map.from_cells(corner))
                    .collect(),
            );
        }
    }
    rings
}

/// Edges between a free and a blocked cell that were not walked yet.
struct Boundary {
    /// Grid corners along a row.
    width: usize,
    /// Per grid corner one bit a direction in which such an edge leaves.
    leaving: Vec<u8>,
}

impl Boundary {
    fn new(map: &OccupancyMap) -> Self {
        let width = map.columns + 1;
        let mut leaving = vec![0; width * (map.rows + 1)];
        for row in 0..map.rows {
            for column in 0..map.columns {
                let (c, r) = (column as i64, row as i64);
                if map.is_blocked(c, r) {
                    continue;
                }
                // The four sides of a free cell, counter-clockwise: who is beyond, where the side starts.
                let sides = [
                    ((0, -1), (0, 0)),
                    ((1, 0), (1, 0)),
                    ((0, 1), (1, 1)),
                    ((-1, 0), (0, 1)),
                ];
                for (direction, ((dc, dr), (ec, er))) in sides.into_iter().enumerate() {
                    if map.is_blocked(c + dc, r + dr) {
                        leaving[(row + er) * width + column + ec] |= 1 << direction;
                    }
                }
            }
        }
        Self { width, leaving }
    }

    /// Walks the boundary from a corner until it is back there and forgets the edges walked.
    fn take_ring(&mut self, start: usize) -> Option<Vec<Point>> {
        if self.leaving[start] == 0 {
            return None;
        }
        let mut corners = Vec::new();
        let (mut at, mut last) = (start, None);
        loop {
            let direction = self.leaving[at].trailing_zeros() as usize;
            let Some((dc, dr)) = DIRECTIONS.get(direction) else {
                break; // Back at the start: as many edges enter a corner as leave it.
            };
            self.leaving[at] &= !(1 << direction);
            if last != Some(direction) {
                corners.push(Point::new(
                    (at % self.width) as f64,
                    (at / self.width) as f64,
                ));
            }
            last = Some(direction);
            at = at.wrapping_add_signed((dc + dr * self.width as i64) as isize);
            if at == start {
                break;
            }
        }
        Some(corners)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pairtrawl_geometry::Pose;

    fn map(rows: &[&str]) -> OccupancyMap {
        // The picture's last line is row 0.
        let cells = rows.iter().rev().flat_map(|r| r.bytes().map(|b| b == b'#'));
        OccupancyMap {
            origin: Pose::new(1.0, 2.0, 0.0),
            resolution: 0.5,
            columns: rows[0].len(),
            rows: rows.len(),
            blocked: cells.collect(),
        }
    }

    fn is_inside(rings: &[Vec<Point>], p: Point) -> bool {
        let mut inside = false;
        for ring in rings {
            for i in 0..ring.len() {
                let (a, b) = (ring[i], ring[(i + 1) % ring.len()]);
                if (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)
                {
                    inside = !inside;
                }
            }
        }
        inside
    }

    #[test]
    fn rings_hold_exactly_the_free_cells() {
        for rows in [
            &["....", ".##.", ".#..", "...."][..],
            &["#.#", ".#.", "#.#"],
            &[".#.", "#.#", ".#."],
            &["##", "##"],
            &["..", ".."],
            &["######", "#....#", "#.##.#", "#.#..#", "######"],
        ] {
            let map = map(rows);
            let rings = free_rings(&map);
            for row in 0..map.rows {
                for column in 0..map.columns {
                    let center = map.from_cells(Point::new(column as f64 + 0.5, row as f64 + 0.5));
                    let free = !map.is_blocked(column as i64, row as i64);
                    assert_eq!(is_inside(&rings, center), free, "{rows:?} {column} {row}");
                }
            }
        }
    }

    #[test]
    fn straight_walls_are_one_edge() {
        let rings = free_rings(&map(&["....", "....", "...."]));
        assert_eq!(rings.len(), 1);
        let corners: Vec<[f64; 2]> = rings[0].iter().map(|p| (*p).into()).collect();
        assert_eq!(corners, [[1.0, 2.0], [3.0, 2.0], [3.0, 3.5], [1.0, 3.5]]);
    }
}
