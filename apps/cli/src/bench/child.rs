use crate::exit::Exit;
use crate::failure::Failure;
use crate::interrupt;
use std::io::Read;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// How often a process is looked at.
const PERIOD: Duration = Duration::from_millis(10);
/// A process that takes this many times its time limit, and this many seconds more, is ended: it asks for the time only
/// between steps of its work.
const PATIENCE: (f64, f64) = (2.0, 30.0);

/// How scenes are planned.
pub struct Child<'a> {
    /// What `pairtrawl plan` is told beyond scene and folder.
    pub arguments: &'a [String],
    /// Its threads.
    pub threads: usize,
    /// Its time limit, s.
    pub limit: Option<f64>,
}

/// How a process ended.
pub struct Ended {
    /// Its exit code; `None` when it was ended.
    pub code: Option<i32>,
    /// Why it was ended, where that was done here.
    pub reason: Option<String>,
    /// What it printed for machines.
    pub output: String,
    /// What it printed as errors.
    pub errors: String,
    /// Its wall time, s.
    pub seconds: f64,
    /// The greatest resident memory that was seen, bytes.
    pub memory: Option<u64>,
}

impl Child<'_> {
    /// Plans a scene into a folder; `None` when someone wanted to stop.
    ///
    /// # Errors
    /// When no process can be made.
    pub fn plan(&self, scene: &Path, folder: &Path) -> Result<Option<Ended>, Failure> {
        let refuse = |error: std::io::Error| {
            let message = format!("cannot run this program again to plan a scene: {error}");
            Failure::new(Exit::Files, message)
        };
        let program = std::env::current_exe().map_err(refuse)?;
        let begin = Instant::now();
        let mut process = Command::new(program)
            .arg("plan")
            .arg(scene)
            .arg("--json")
            .arg("--output")
            .arg(folder)
            .args(self.arguments)
            .env("RAYON_NUM_THREADS", self.threads.to_string())
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .map_err(refuse)?;
        let (output, errors) = (process.stdout.take(), process.stderr.take());
        let status_file = format!("/proc/{}/status", process.id());
        std::thread::scope(|scope| {
            // One thread a pipe, so that neither can fill up and block the process.
            let output = scope.spawn(move || output.map(read));
            let errors = scope.spawn(move || errors.map(read));
            let (mut memory, mut reason) = (None, None);
            let status = loop {
                memory = resident(&status_file).max(memory);
                if let Some(status) = process.try_wait().map_err(refuse)? {
                    break status;
                }
                let seconds = begin.elapsed().as_secs_f64();
                let is_late = |limit: f64| seconds > PATIENCE.0 * limit + PATIENCE.1;
                // A process that has ended meanwhile cannot be killed any more, which is as good.
                if interrupt::requested() {
                    let _ = process.kill();
                } else if reason.is_none() && self.limit.is_some_and(is_late) {
                    reason = Some(format!("no answer after {seconds:.0} s: ended"));
                    let _ = process.kill();
                }
                std::thread::sleep(PERIOD);
            };
            let seconds = begin.elapsed().as_secs_f64();
            let ended = Ended {
                code: status.code(),
                reason,
                output: output.join().ok().flatten().unwrap_or_default(),
                errors: errors.join().ok().flatten().unwrap_or_default(),
                seconds,
                memory,
            };
            Ok((!interrupt::requested()).then_some(ended))
        })
    }
}

/// All that a pipe says, as far as it is text.
fn read(mut pipe: impl Read) -> String {
    let mut bytes = Vec::new();
    // What was read before a failure counts.
    let _ = pipe.read_to_end(&mut bytes);
    String::from_utf8_lossy(&bytes).into_owned()
}

/// The greatest resident memory of a process so far, bytes; `None` where the system has no such file.
fn resident(status_file: &str) -> Option<u64> {
    let status = std::fs::read_to_string(status_file).ok()?;
    let line = status.lines().find_map(|l| l.strip_prefix("VmHWM:"))?;
    let kibibytes: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(1024 * kibibytes)
}
