use pairtrawl_model::{Event, Frames, RehearsalFrame, Scene};

/// More frames than this are thinned out for showing: a page must stay small, and motion between them is smooth.
pub(super) const MOST: usize = 1200;

/// Physics in motion; `None` when nothing was recorded.
pub(super) fn of(all: &[RehearsalFrame], events: Vec<Event>, scene: &Scene) -> Option<Frames> {
    let last = all.len().checked_sub(1)?;
    let stride = all.len().div_ceil(MOST);
    let shown = || (0..last).step_by(stride).chain([last]).map(|i| &all[i]);
    Some(Frames {
        times: shown().map(|f| f.time).collect(),
        left: shown().map(|f| f.robots.left).collect(),
        right: shown().map(|f| f.robots.right).collect(),
        net: shown().map(|f| f.net.clone()).collect(),
        objects: shown().map(|f| f.objects.clone()).collect(),
        left_tension: shown().map(|f| f.tension[0]).collect(),
        right_tension: shown().map(|f| f.tension[1]).collect(),
        tension_limit: scene.physics.tension_limit,
        events,
    })
}
