use crate::arguments::BenchPlanArguments;
use crate::bench::{Child, Ended, SceneFile, scenes_below};
use crate::exit::Exit;
use crate::failure::Failure;
use crate::interrupt;
use crate::output::{Done, Report, to_json};
use crate::results::in_folder;
use crate::trials::Trials;
use pairtrawl::Candidate;
use pairtrawl::execute::ExecutionObserver;
use pairtrawl::files::{read_plan, read_scene};
use pairtrawl::model::numbers::{duration, memory};
use pairtrawl::model::{Bench, BenchGroup, BenchScene};
use serde_json::Value;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Subfolder of the results of single scenes.
const SCENES: &str = "scenes";

/// `pairtrawl bench-plan`: plans a folder of scenes and counts.
pub fn bench_plan(arguments: &BenchPlanArguments) -> Result<Done, Failure> {
    let files = scenes_below(&arguments.folder)?;
    in_folder(
        &arguments.output,
        &["bench.json", "bench.html"],
        |results| {
            let cores = std::thread::available_parallelism().map_or(1, usize::from);
            let jobs = arguments.jobs.map_or(cores, usize::from).min(files.len());
            let told = arguments.planning.as_arguments();
            let child = Child {
                arguments: &told,
                threads: (cores / jobs).max(1),
                limit: arguments.planning.time_limit,
            };
            let scenes = interrupt::gracefully(|| {
                plan_all(&files, jobs, &child, &arguments.output.join(SCENES))
            })?;
            let bench = Bench {
                folder: arguments.folder.display().to_string(),
                arguments: told.clone(),
                jobs,
                threads: child.threads,
                wanted: files.len(),
                interrupted: scenes.len() < files.len(),
                groups: groups(&scenes),
                total: BenchGroup::of("all", &scenes.iter().collect::<Vec<_>>()),
                scenes,
            };
            let written = results.write(&[
                ("bench.json", format!("{}\n", to_json(&bench)?)),
                ("bench.html", pairtrawl::report::bench_html(&bench)),
            ])?;
            let exit = match () {
                () if bench.interrupted => Exit::Interrupted,
                () if bench.total.invalid > 0 => Exit::Invalid,
                () => Exit::Done,
            };
            let text = bench_text(&bench);
            Report::new("bench-plan", exit, bench).done(exit, text, &[], &written)
        },
    )
}

/// Plans the scenes, several at once; those that were planned before someone wanted to stop, in their order.
fn plan_all(
    files: &[SceneFile],
    jobs: usize,
    child: &Child<'_>,
    folder: &Path,
) -> Result<Vec<BenchScene>, Failure> {
    let bar = Trials::new(files.len(), "planning");
    let next = AtomicUsize::new(0);
    let ended: Mutex<Vec<Result<Option<BenchScene>, Failure>>> = Mutex::default();
    std::thread::scope(|scope| {
        for _ in 0..jobs {
            scope.spawn(|| {
                while !interrupt::requested() {
                    let index = next.fetch_add(1, Ordering::Relaxed);
                    let Some(file) = files.get(index) else {
                        break;
                    };
                    let scene = plan_one(file, child, folder);
                    let failed = scene.is_err();
                    ended
                        .lock()
                        .unwrap_or_else(|poisoned| poisoned.into_inner())
                        .push(scene);
                    bar.finished(index);
                    if failed {
                        next.store(files.len(), Ordering::Relaxed);
                    }
                }
            });
        }
    });
    bar.finish();
    let ended = ended
        .into_inner()
        .unwrap_or_else(|poisoned| poisoned.into_inner());
    let mut scenes = Vec::with_capacity(files.len());
    for scene in ended {
        scenes.extend(scene?);
    }
    scenes.sort_by(|a, b| a.name.cmp(&b.name));
    Ok(scenes)
}

/// Plans a scene and makes its certificate again; `None` when someone wanted to stop.
fn plan_one(
    file: &SceneFile,
    child: &Child<'_>,
    folder: &Path,
) -> Result<Option<BenchScene>, Failure> {
    let own = folder.join(&file.name);
    let Some(ended) = child.plan(&file.path, &own)? else {
        return Ok(None);
    };
    let loaded = read_scene(&file.path).ok();
    let is_planned = ended.code == Some(0);
    let valid = is_planned.then(|| {
        let plan = read_plan(&own.join("plan.json")).ok();
        plan.zip(loaded.as_ref()).is_some_and(|(plan, loaded)| {
            let trajectory = plan.trajectory(&loaded.scene);
            let candidate = Candidate::of_file(&plan, &trajectory);
            pairtrawl::check(&loaded.scene, &loaded.reference, &candidate).is_valid()
        })
    });
    let group = loaded.as_ref().map_or_else(
        || "unreadable".to_owned(),
        |loaded| without_seed(&loaded.scene.name).to_owned(),
    );
    let there = |name: &str| {
        let is_there = own.join(name).is_file();
        is_there.then(|| format!("{SCENES}/{}/{name}", file.name))
    };
    // What an earlier run left is not this one's.
    let (page, picture) = match is_planned {
        true => ("report.html", "plan.svg"),
        false => ("failed.html", "failed.svg"),
    };
    Ok(Some(BenchScene {
        name: file.name.clone(),
        group,
        objects: loaded.map(|loaded| loaded.scene.objects.len()),
        valid,
        page: there(page),
        picture: there(picture),
        ..from_output(&ended)
    }))
}

/// What the process says of itself.
fn from_output(ended: &Ended) -> BenchScene {
    // One line of JSON; what does not fit is shown as it stands.
    let said: Value = serde_json::from_str(ended.output.trim()).unwrap_or(Value::Null);
    let text = |pointer: &str| {
        said.pointer(pointer)
            .and_then(Value::as_str)
            .map(str::to_owned)
    };
    let count = |pointer: &str| {
        let number = said.pointer(pointer).and_then(Value::as_u64);
        number.and_then(|n| usize::try_from(n).ok())
    };
    let left = |why: &str| {
        let all = said.pointer("/left_out").and_then(Value::as_array);
        let mut all = all.into_iter().flatten();
        all.by_ref().filter(|left| left["why"] == why).count()
    };
    let unknown = || match ended.errors.trim() {
        "" => "it was ended from outside".to_owned(),
        errors => errors.to_owned(),
    };
    BenchScene {
        name: String::new(),
        group: String::new(),
        exit_code: ended.code,
        message: (ended.code != Some(0)).then(|| {
            ended
                .reason
                .clone()
                .or_else(|| text("/message"))
                .unwrap_or_else(unknown)
        }),
        claim: text("/details/claim"),
        objects: None,
        gathered: count("/gathers").unwrap_or(0),
        left_proven: left("proven"),
        left_not_found: left("not_found"),
        valid: None,
        iterations: count("/solver/iterations"),
        cost: said.pointer("/cost/total").and_then(Value::as_f64),
        rehearsal: text("/rehearsal/status"),
        seconds: ended.seconds,
        memory: ended.memory,
        page: None,
        picture: None,
    }
}

/// A scene's name without a number at its end.
fn without_seed(name: &str) -> &str {
    match name.rsplit_once('-') {
        Some((rest, seed)) if !rest.is_empty() && seed.bytes().all(|b| b.is_ascii_digit()) => rest,
        _ => name,
    }
}

fn groups(scenes: &[BenchScene]) -> Vec<BenchGroup> {
    let mut groups: BTreeMap<&str, Vec<&BenchScene>> = BTreeMap::new();
    for scene in scenes {
        groups.entry(&scene.group).or_default().push(scene);
    }
    (groups.iter())
        .map(|(name, scenes)| BenchGroup::of(name, scenes))
        .collect()
}

fn bench_text(bench: &Bench) -> String {
    let mut text = String::new();
    let interrupted = match bench.interrupted {
        true => format!("INTERRUPTED after {} of ", bench.scenes.len()),
        false => String::new(),
    };
    let _ = writeln!(
        text,
        "{interrupted}{} scenes of {}, {} at once, threads of each: {}",
        bench.wanted, bench.folder, bench.jobs, bench.threads
    );
    let longest = bench.groups.iter().map(|g| g.name.chars().count()).max();
    let width = longest.unwrap_or(0).max(5);
    let _ = writeln!(
        text,
        "  {:<width$} {:>9} {:>11} {:>16} {:>16} {:>28} {:>8}  no plan",
        "group",
        "planned",
        "gathered",
        "proven/not found",
        "iterations",
        "time p50 / 90 % / most",
        "memory"
    );
    for group in bench.groups.iter().chain([&bench.total]) {
        let iterations = group
            .iterations
            .map_or_else(String::new, |[p50, p90, most]| {
                format!("{p50} / {p90} / {most}")
            });
        let seconds = group
            .seconds
            .map_or_else(String::new, |times| times.map(duration).join(" / "));
        let failures: Vec<String> = (group.failures.iter())
            .map(|f| match f.exit_code {
                Some(code) => format!("{} x exit {code}", f.scenes),
                None => format!("{} x ended", f.scenes),
            })
            .collect();
        let _ = writeln!(
            text,
            "  {:<width$} {:>9} {:>11} {:>16} {:>16} {:>28} {:>8}  {}",
            group.name,
            format!("{}/{}", group.planned, group.scenes),
            format!("{}/{}", group.gathered, group.objects),
            format!("{}/{}", group.left_proven, group.left_not_found),
            iterations,
            seconds,
            group.memory.map_or_else(String::new, memory),
            failures.join(", ")
        );
    }
    if bench.total.rehearsed > 0 {
        let _ = writeln!(
            text,
            "{} of {} rehearsals passed",
            bench.total.passed, bench.total.rehearsed
        );
    }
    for scene in &bench.scenes {
        if scene.valid == Some(false) {
            let _ = writeln!(text, "{}: its certificate does not hold", scene.name);
        }
        if let Some(message) = &scene.message {
            let end = match scene.exit_code {
                Some(code) => format!("exit {code}"),
                None => "ended".to_owned(),
            };
            // The rest is in the file and on the page.
            let first = message.lines().next().unwrap_or_default();
            let _ = writeln!(text, "{}: {end}: {first}", scene.name);
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::without_seed;

    #[test]
    fn a_group_is_a_name_without_its_seed() {
        assert_eq!(
            without_seed("hall-15x10-3-40-0.62-7"),
            "hall-15x10-3-40-0.62"
        );
        assert_eq!(without_seed("paper-experiment"), "paper-experiment");
        assert_eq!(without_seed("-7"), "-7");
        assert_eq!(without_seed("7"), "7");
    }
}
