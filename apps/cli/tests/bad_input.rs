//! Every bad input gets one clear message and the right exit code; no panic, no output file.

mod program;

use program::{SMALL, files_below, folder_with, run, stderr, stdout, text};
use std::path::Path;

/// Plans `scene` and expects it to be refused with `code` and a message that has all of `words`.
fn refused(scene: &Path, code: i32, words: &[&str]) {
    refused_with(scene, &[], code, words);
}

fn refused_with(scene: &Path, more: &[&str], code: i32, words: &[&str]) {
    let out = tempfile::tempdir().expect("a folder");
    let target = out.path().join("plan");
    let mut arguments = vec!["plan", text(scene), "-o", text(&target), "--no-rehearsal"];
    arguments.extend(more);
    let ended = run(&arguments);
    let said = stderr(&ended);
    assert_eq!(ended.status.code(), Some(code), "{said}");
    assert_eq!(
        said.matches("error:").count(),
        1,
        "one message, not: {said}"
    );
    assert!(
        !said.contains("panicked") && !said.contains("internal fault"),
        "{said}"
    );
    for word in words {
        assert!(said.contains(word), "the message lacks {word:?}: {said}");
    }
    assert_eq!(stdout(&ended), "");
    // A proof leaves itself and its pictures behind, bad input nothing.
    let left_behind: &[&str] = match code {
        4 => &[
            "plan/failed.html",
            "plan/failed.svg",
            "plan/infeasible.json",
        ],
        _ => &[],
    };
    assert_eq!(files_below(out.path()), left_behind);
}

/// The small scene with one piece of text replaced.
fn changed(from: &str, to: &str) -> String {
    assert!(SMALL.contains(from), "nothing to replace: {from}");
    SMALL.replace(from, to)
}

fn refused_text(scene: &str, words: &[&str]) {
    let (_folder, path) = folder_with(scene);
    refused(&path, 3, words);
}

#[test]
fn the_small_scene_itself_is_not_refused() {
    let (folder, path) = folder_with(SMALL);
    let out = folder.path().join("plan");
    let ended = run(&["plan", text(&path), "-o", text(&out), "--no-rehearsal"]);
    assert_eq!(ended.status.code(), Some(0), "{}", stderr(&ended));
}

#[test]
fn a_missing_file() {
    refused(Path::new("no/such/scene.toml"), 3, &["no/such/scene.toml"]);
}

#[test]
fn a_directory() {
    let folder = tempfile::tempdir().expect("a folder");
    refused(folder.path(), 3, &[text(folder.path())]);
}

#[test]
fn bytes_that_are_no_text() {
    let (_folder, path) = folder_with([0xff, 0xfe, 0x00, 0x80]);
    refused(&path, 3, &["UTF-8"]);
}

#[test]
fn an_empty_file() {
    refused_text("", &["empty"]);
}

#[test]
fn an_unknown_key_names_the_one_that_was_meant() {
    refused_text(
        &changed("[net]\nlength", "[net]\nlenght"),
        &["lenght", "length"],
    );
}

#[test]
fn a_wrong_format_number() {
    refused_text(
        &changed("scene/1", "scene/2"),
        &["pairtrawl-scene/2", "pairtrawl-scene/1"],
    );
}

#[test]
fn numbers_that_are_not_finite() {
    for number in ["nan", "inf", "-inf"] {
        refused_text(
            &changed(
                "position = [2.0, 1.5]",
                &format!("position = [2.0, {number}]"),
            ),
            &["position"],
        );
        refused_text(
            &changed("length = 1.2", &format!("length = {number}")),
            &["length"],
        );
        refused_text(
            &changed("max = [4.0, 3.0]", &format!("max = [{number}, 3.0]")),
            &["max"],
        );
        refused_text(
            &changed(
                "heading = 0.0\n\n[end]",
                &format!("heading = {number}\n\n[end]"),
            ),
            &["heading"],
        );
    }
}

#[test]
fn sizes_that_are_not_positive() {
    refused_text(
        &changed("size = [0.05, 0.05]", "size = [0.05, -0.05]"),
        &["size", "-0.05"],
    );
    refused_text(
        &changed("length = 1.2", "length = -1.2"),
        &["length", "-1.2"],
    );
    refused_text(
        &format!("{SMALL}\n[robot]\nradius = -0.24\n"),
        &["radius", "-0.24"],
    );
    refused_text(
        &changed("box = [1.8, 0.0, 2.2, 0.4]", "circle = [1.8, 0.0, -0.2]"),
        &["circle", "-0.2"],
    );
    refused_text(
        &changed("box = [1.8, 0.0, 2.2, 0.4]", "box = [2.2, 0.0, 1.8, 0.4]"),
        &["box"],
    );
}

#[test]
fn an_area_beyond_all_bounds() {
    refused_text(
        &changed("max = [4.0, 3.0]", "max = [1e308, 3.0]"),
        &["area"],
    );
    refused_text(
        &changed(
            "min = [0.0, 0.0]\nmax = [4.0, 3.0]",
            "min = [-1e308, -1e308]\nmax = [1e308, 1e308]",
        ),
        &["area"],
    );
}

#[test]
fn a_resolution_of_zero_or_of_a_nanometer() {
    refused_text(
        &changed("resolution = 0.05", "resolution = 0.0"),
        &["resolution"],
    );
    refused_text(
        &changed("resolution = 0.05", "resolution = 1e-9"),
        &["resolution"],
    );
}

#[test]
fn an_object_in_an_obstacle_or_outside() {
    refused_text(
        &changed("position = [2.0, 1.5]", "position = [2.0, 0.2]"),
        &["object", "obstacle"],
    );
    refused_text(
        &changed("position = [2.0, 1.5]", "position = [5.0, 1.5]"),
        &["object", "area"],
    );
}

#[test]
fn a_start_or_end_that_cannot_be_taken() {
    refused_text(
        &changed("left = [0.5, 1.85]", "left = [2.0, 0.5]"),
        &["start", "obstacle"],
    );
    refused_text(
        &changed("left = [3.5, 1.85]", "left = [4.5, 1.85]"),
        &["end", "area"],
    );
    refused_text(
        &changed("left = [0.5, 1.85]", "left = [0.5, 1.30]"),
        &["start", "0.48"],
    );
}

#[test]
fn brackets_without_end() {
    let nested = format!("{SMALL}\n[planner]\nmax_step = {}", "[".repeat(100_000));
    refused_text(&nested, &[]);
}

#[test]
fn a_net_that_is_shorter_than_the_start_is_proven_infeasible() {
    let (_folder, path) = folder_with(changed("length = 1.2", "length = 0.6"));
    refused(&path, 4, &["0.6", "0.7"]);
    let (_folder, path) = folder_with(SMALL);
    refused_with(&path, &["--net-length", "0.6"], 4, &["0.6", "0.7"]);
}

#[test]
fn too_few_waypoints_are_proven_infeasible() {
    let (_folder, path) = folder_with(SMALL);
    refused_with(&path, &["--waypoints", "20"], 4, &["20 waypoints", "61"]);
}

#[cfg(unix)]
#[test]
fn a_scene_that_never_ends() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("scene.toml");
    std::os::unix::fs::symlink("/dev/zero", &path).expect("a link");
    refused(&path, 3, &[]);
}

#[cfg(unix)]
#[test]
fn a_scene_that_may_not_be_read() {
    use std::os::unix::fs::PermissionsExt;
    let (_folder, path) = folder_with(SMALL);
    std::fs::set_permissions(&path, std::fs::Permissions::from_mode(0o000)).expect("permissions");
    // Root may read everything: nothing to see then.
    if std::fs::read(&path).is_err() {
        refused(&path, 8, &[text(&path)]);
    }
}

/// The small scene over a ROS map with this image.
fn map_scene(image: &[u8]) -> tempfile::TempDir {
    let (folder, _) = folder_with(changed(
        "min = [0.0, 0.0]\nmax = [4.0, 3.0]\nresolution = 0.05",
        "map = \"hall.yaml\"",
    ));
    std::fs::write(folder.path().join("hall.pgm"), image).expect("the image");
    let yaml = "image: hall.pgm\nresolution: 0.05\norigin: [0.0, 0.0, 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
    std::fs::write(folder.path().join("hall.yaml"), yaml).expect("the map");
    folder
}

fn refused_map(image: &[u8]) {
    let folder = map_scene(image);
    refused(&folder.path().join("scene.toml"), 3, &["hall.pgm"]);
}

/// 80 x 60 free cells.
fn free_image() -> Vec<u8> {
    let mut image = b"P5\n80 60\n255\n".to_vec();
    image.extend(std::iter::repeat_n(254, 80 * 60));
    image
}

#[test]
fn a_map_of_free_cells_is_not_refused() {
    let folder = map_scene(&free_image());
    let out = folder.path().join("plan");
    let scene = folder.path().join("scene.toml");
    let ended = run(&["plan", text(&scene), "-o", text(&out), "--no-rehearsal"]);
    assert_eq!(ended.status.code(), Some(0), "{}", stderr(&ended));
}

#[test]
fn maps_that_are_broken() {
    refused_map(b"P5\n0 60\n255\n");
    refused_map(b"P5\n65536 65536\n255\n");
    refused_map(&free_image()[..2000]);
    refused_map(b"P39151\n80 60\n255\n");
    refused_map(b"");
}

#[test]
fn a_map_that_is_missing() {
    let folder = map_scene(b"");
    std::fs::remove_file(folder.path().join("hall.pgm")).expect("removed");
    refused(&folder.path().join("scene.toml"), 3, &["hall.pgm"]);
    std::fs::remove_file(folder.path().join("hall.yaml")).expect("removed");
    refused(&folder.path().join("scene.toml"), 3, &["hall.yaml"]);
}

#[cfg(unix)]
#[test]
fn a_map_that_never_ends() {
    let folder = map_scene(b"");
    let image = folder.path().join("hall.pgm");
    std::fs::remove_file(&image).expect("removed");
    std::os::unix::fs::symlink("/dev/zero", &image).expect("a link");
    refused(&folder.path().join("scene.toml"), 3, &["hall.pgm"]);
}
