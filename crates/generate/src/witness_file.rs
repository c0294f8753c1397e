use crate::Generated;
use pairtrawl_geometry::Pose;
use serde_json::json;

/// The witness as a `pairtrawl-plan/1` file with the fields that reading a plan requires, marked `foreign`: it names no
/// scene hash, since the scene file is written elsewhere.
pub fn witness_json(generated: &Generated) -> String {
    let poses = |poses: &[Pose]| {
        poses
            .iter()
            .map(|p| <[f64; 3]>::from(*p))
            .collect::<Vec<_>>()
    };
    let w = &generated.witness;
    json!({
        "format": "pairtrawl-plan/1",
        "foreign": true,
        "net_length": generated.net_length,
        "step_time": w.step_time,
        "left": poses(&w.left),
        "right": poses(&w.right),
    })
    .to_string()
}
