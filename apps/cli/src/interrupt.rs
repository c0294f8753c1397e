//! Ctrl-C: ends at once with 130, but never in the middle of writing a file.
//!
//! Long work that keeps its finished parts runs inside [`gracefully`]: there the first Ctrl-C is a request, the second
//! one ends the program.

use crate::exit::Exit;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

static REQUESTED: AtomicBool = AtomicBool::new(false);
static GRACEFUL: AtomicBool = AtomicBool::new(false);
static WRITING: Mutex<()> = Mutex::new(());

/// Installs the handler. Without one (it cannot be installed) Ctrl-C ends the program as the system does.
pub fn install() {
    let _ = ctrlc::set_handler(|| {
        let again = REQUESTED.swap(true, Ordering::SeqCst);
        if GRACEFUL.load(Ordering::SeqCst) && !again {
            return;
        }
        // Waits for files that are being written: milliseconds.
        let _writing = WRITING
            .lock()
            .unwrap_or_else(|poisoned| poisoned.into_inner());
        crate::earlier::set_aside();
        std::process::exit(Exit::Interrupted.code());
    });
}

/// True after Ctrl-C.
pub fn requested() -> bool {
    REQUESTED.load(Ordering::SeqCst)
}

/// Writes files: Ctrl-C waits until it is done.
pub fn while_writing<T>(write: impl FnOnce() -> T) -> T {
    let _writing = WRITING
        .lock()
        .unwrap_or_else(|poisoned| poisoned.into_inner());
    write()
}

/// Does long work that asks [`requested`] and keeps its finished parts: here the first Ctrl-C is a request.
pub fn gracefully<T>(work: impl FnOnce() -> T) -> T {
    GRACEFUL.store(true, Ordering::SeqCst);
    let result = work();
    GRACEFUL.store(false, Ordering::SeqCst);
    result
}
