//! Threads to work on. Each number of threads has one pool, made when it is first asked for. A process that was forked has
//! none of its parent's threads, so it makes its own.

use rayon::{ThreadPool, ThreadPoolBuilder};
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

/// The pools by process and number of threads.
type Pools = BTreeMap<(u32, usize), Arc<ThreadPool>>;

static POOLS: Mutex<Pools> = Mutex::new(BTreeMap::new());

/// A pool of so many threads; 0: as many as the machine has, or as `RAYON_NUM_THREADS` says.
pub fn pool(threads: usize) -> Result<Arc<ThreadPool>, String> {
    let mut pools = POOLS.lock().unwrap_or_else(PoisonError::into_inner);
    let key = (std::process::id(), threads);
    if let Some(pool) = pools.get(&key) {
        return Ok(Arc::clone(pool));
    }
    let made = Arc::new(own_pool(threads)?);
    pools.insert(key, Arc::clone(&made));
    Ok(made)
}

/// A pool of so many threads that nobody else uses.
pub fn own_pool(threads: usize) -> Result<ThreadPool, String> {
    let builder = ThreadPoolBuilder::new().num_threads(threads);
    builder.build().map_err(|error| error.to_string())
}
