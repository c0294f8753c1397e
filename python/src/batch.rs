//! Many plans at once. Each is planned from beginning to end by one thread, so that none waits for another, and a limit of time
//! counts the work on its own scene.

use crate::options::Given;
use crate::pools::own_pool;
use crate::scene_state::SceneState;
use crate::work::{Event, QuietWatch, STACK_BYTES, Watch, words};
use pairtrawl::{PlanError, Planned};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

/// What comes of one scene of many: the planner's answer or the words of a panic, and the seconds that it took.
pub type Answer = (Result<Result<Planned, PlanError>, String>, f64);

/// A scene and its options.
pub type Job<'a> = (&'a SceneState, &'a Given);

/// Plans scenes on as many threads as the current pool has; answers come in order. Where there are fewer scenes than threads,
/// each plan has several.
pub fn all(watch: &Watch, jobs: &[Job<'_>]) -> Vec<Answer> {
    let threads = rayon::current_num_threads();
    let planners = threads.min(jobs.len()).max(1);
    let next = AtomicUsize::new(0);
    let answers: Vec<OnceLock<Answer>> = jobs.iter().map(|_| OnceLock::new()).collect();
    let work = || {
        let Ok(pool) = own_pool(threads / planners) else {
            return;
        };
        while !watch.is_stopped() {
            let index = next.fetch_add(1, Ordering::Relaxed);
            let (Some(job), Some(answer)) = (jobs.get(index), answers.get(index)) else {
                return;
            };
            let _ = answer.set(pool.install(|| one(watch, index, *job)));
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..planners {
            let thread = std::thread::Builder::new().stack_size(STACK_BYTES);
            // With fewer threads than wanted the others plan more.
            let _ = thread.spawn_scoped(scope, work);
        }
    });
    let unplanned = || (Err("there was no thread to plan it".to_owned()), 0.0);
    let answers = answers.into_iter().map(OnceLock::into_inner);
    answers
        .map(|answer| answer.unwrap_or_else(unplanned))
        .collect()
}

fn one(watch: &Watch, index: usize, (state, given): Job<'_>) -> Answer {
    let (loaded, begin) = (&state.loaded, Instant::now());
    let planned = catch_unwind(AssertUnwindSafe(|| {
        let mut quiet = QuietWatch(watch);
        pairtrawl::plan(&loaded.scene, &loaded.reference, &given.plan, &mut quiet)
    }));
    watch.report(Event::Done(index));
    let seconds = begin.elapsed().as_secs_f64();
    (planned.map_err(|panic| words(panic.as_ref())), seconds)
}
