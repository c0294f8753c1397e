//! Names beside curves that keep their distance from each other.

/// Heights near the wanted ones, in their order, at least `gap` apart and within bounds as long as there is room.
pub(super) fn spread(wanted: &[f64], gap: f64, (least, most): (f64, f64)) -> Vec<f64> {
    let mut order: Vec<usize> = (0..wanted.len()).collect();
    order.sort_by(|&a, &b| wanted[a].total_cmp(&wanted[b]));
    let mut heights = vec![0.0; wanted.len()];
    let mut lowest = least;
    for &i in &order {
        heights[i] = f64::max(wanted[i], lowest);
        lowest = heights[i] + gap;
    }
    // What was pushed out at the far end pushes the others back.
    let mut highest = most;
    for &i in order.iter().rev() {
        heights[i] = heights[i].min(highest);
        highest = heights[i] - gap;
    }
    heights
}

#[cfg(test)]
mod tests {
    use super::spread;

    #[test]
    fn names_keep_apart_and_inside() {
        let heights = spread(&[50.0, 52.0, 51.0, 10.0, 99.0], 14.0, (0.0, 100.0));
        let mut sorted = heights.clone();
        sorted.sort_by(f64::total_cmp);
        assert!(
            sorted.windows(2).all(|w| w[1] - w[0] >= 14.0 - 1e-9),
            "{heights:?}"
        );
        assert!(sorted[0] >= 0.0 && sorted[4] <= 100.0, "{heights:?}");
        assert!(
            heights[0] < heights[2] && heights[2] < heights[1],
            "order is kept: {heights:?}"
        );
    }
}
