//! Over which net lengths the cost hardly changes.

use pairtrawl_model::{Cost, LengthCurve, LengthPoint, LengthRefusal};

fn cost(total: f64) -> Cost {
    let cost = Cost {
        distance: total,
        ..Cost::default()
    };
    assert_eq!(cost.total(), total);
    cost
}

/// Points at (length, J); no plan where J is `None`.
fn curve(minimum: (f64, f64), points: &[(f64, Option<f64>)]) -> LengthCurve {
    let point = |&(net_length, total): &(f64, Option<f64>)| LengthPoint {
        net_length,
        outcome: total
            .map(cost)
            .ok_or_else(|| LengthRefusal::NotFound("narrow".to_owned())),
    };
    LengthCurve {
        title: String::new(),
        points: points.iter().map(point).collect(),
        minimum: Some((minimum.0, cost(minimum.1))),
        interrupted: false,
    }
}

fn assert_range(curve: &LengthCurve, from: f64, to: f64) {
    let (low, high) = curve.flat_range(0.01).expect("a range");
    assert!(
        (low - from).abs() < 1e-12 && (high - to).abs() < 1e-12,
        "{low} to {high}, not {from} to {to}"
    );
}

#[test]
fn it_ends_between_solved_lengths_where_the_cost_has_risen_by_the_share() {
    let points = [
        (1.0, Some(104.0)),
        (1.5, Some(100.5)),
        (2.0, Some(100.5)),
        (2.5, Some(102.5)),
    ];
    // On the grid alone it would be 1.5 to 2.0.
    assert_range(
        &curve((1.75, 100.0), &points),
        1.5 - 0.5 * 0.5 / 3.5,
        2.0 + 0.5 * 0.5 / 2.0,
    );
}

#[test]
fn it_reaches_into_the_first_interval_when_no_solved_length_is_within() {
    let points = [(1.0, Some(110.0)), (2.0, Some(104.0))];
    assert_range(
        &curve((1.5, 100.0), &points),
        1.5 - 0.5 * 0.1,
        1.5 + 0.5 * 0.25,
    );
}

#[test]
fn it_ends_at_a_length_without_a_plan_and_at_the_ends_of_the_curve() {
    let points = [
        (1.0, Some(100.1)),
        (1.2, None),
        (1.4, Some(100.2)),
        (1.6, Some(100.0)),
        (1.8, Some(100.9)),
    ];
    assert_range(&curve((1.6, 100.0), &points), 1.4, 1.8);
}

#[test]
fn there_is_none_without_a_minimum() {
    let mut curve = curve((1.0, 100.0), &[(1.0, None)]);
    curve.minimum = None;
    assert_eq!(curve.flat_range(0.01), None);
}
