//! What the filter lets pass.

use crate::filter::{Filter, Point};

fn point(theta: f64, phi: f64) -> Point {
    Point { theta, phi }
}

#[test]
fn takes_what_improves_violation_or_barrier() {
    let from = point(1.0, 100.0);
    for (to, accepted) in [
        (point(0.5, 100.0), true),
        (point(0.5, 900.0), true),
        (point(1.0, 90.0), true),
        (point(1.5, 90.0), true),
        (point(1.0, 100.0), false),
        (point(1.5, 101.0), false),
        (point(0.5, f64::NAN), false),
        (point(0.5, f64::INFINITY), false),
        (point(f64::NAN, 100.0), false),
    ] {
        // The slope is too flat for the barrier function alone to decide.
        assert_eq!(
            Filter::default().accepts(from, to, 1.0, -1e-9),
            accepted,
            "{to:?}"
        );
    }
}

#[test]
fn bounds_the_violation() {
    let mut filter = Filter::default();
    assert!(!filter.accepts(point(1.0, 100.0), point(2e4, 0.0), 1.0, -1.0));
    assert!(filter.accepts(point(1.0, 100.0), point(9e3, 0.0), 1.0, -1.0));
}

#[test]
fn never_returns_to_where_it_was() {
    let mut filter = Filter::default();
    let (first, second) = (point(1.0, 100.0), point(0.1, 150.0));
    assert!(filter.accepts(first, second, 1.0, 1.0));
    // Better than `second` in the barrier function, but no better than `first` in either.
    assert!(!filter.accepts(second, point(1.0, 100.0), 1.0, 1.0));
    assert!(!filter.accepts(second, point(1.2, 120.0), 1.0, 1.0));
    assert!(filter.accepts(second, point(0.9, 120.0), 1.0, 1.0));
    filter.clear();
    assert!(
        filter.accepts(second, point(1.2, 120.0), 1.0, 1.0),
        "forgotten"
    );
}

#[test]
fn wants_a_sufficient_decrease_where_nothing_is_violated() {
    let from = point(0.0, 100.0);
    let mut filter = Filter::default();
    // A slope of -10 and a full step: less than a ten-thousandth of the promise is no step.
    assert!(!filter.accepts(from, point(0.0, 100.0 - 9e-4), 1.0, -10.0));
    assert!(filter.accepts(from, point(0.0, 100.0 - 1.1e-3), 1.0, -10.0));
    assert!(filter.accepts(from, point(0.0, 100.0 - 1.1e-4), 0.1, -10.0));
    // Such steps leave nothing behind in the filter.
    assert!(filter.accepts(from, point(0.0, 99.0), 1.0, -10.0));
}
