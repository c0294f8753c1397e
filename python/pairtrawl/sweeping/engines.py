"""Who plans the batches of a sweep: the workers of a Dask or a Ray cluster, or the threads of this process.

An engine takes batches and yields each with its rows, in the order in which they are done. It takes a new batch only when a worker
is about to be idle, so that a sweep of any size needs the memory of a few batches.
"""

from __future__ import annotations

import logging
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from pairtrawl.sweeping.jobs import Job
from pairtrawl.sweeping.rows import Row, compute, lost

if TYPE_CHECKING:
    from distributed import Client

Batch = list[Job]
Done = Iterator[tuple[Batch, list[Row]]]

_AHEAD = 2
"""Batches for each worker: the one that it plans, and the one that waits for it."""


def on_threads(batches: Iterator[Batch], workers: int | None) -> Done:
    """One batch after the other, on the threads of this process."""
    for batch in batches:
        yield batch, compute(batch, threads=workers)


def on_dask(batches: Iterator[Batch], client: Client | None, workers: int | None) -> Done:
    """On the workers of a Dask cluster, one thread for each plan.

    Batches of a worker that dies are planned by others. What was with several workers when they died is set aside, and planned
    when nothing else runs: then it is plain what kills them, and its row says so.
    """
    from distributed import KilledWorker, as_completed

    with _dask_client(client, workers) as cluster:
        running: dict[Any, Batch] = {}
        aside: list[Batch] = []
        done = as_completed()

        def fill() -> None:
            most = _AHEAD * max(1, sum(cluster.nthreads().values()))
            while len(running) < most and (batch := next(batches, None)) is not None:
                future = cluster.submit(compute, batch, pure=False)
                running[future] = batch
                done.add(future)

        fill()
        for future in done:
            batch, error = running.pop(future), future.exception()
            if error is None:
                yield batch, future.result()
            elif isinstance(error, KilledWorker):
                aside.append(batch)
            else:
                raise error
            fill()
        for batch in aside:
            yield from _alone(cluster, batch)


def _alone(cluster: Client, batch: Batch) -> Done:
    """A batch on a cluster that does nothing else; halved until what kills its workers stands alone."""
    from distributed import KilledWorker

    try:
        yield batch, cluster.submit(compute, batch, pure=False).result()
    except KilledWorker as error:
        middle = len(batch) // 2
        if middle == 0:
            yield batch, [lost(batch[0], f"every worker that planned it died: {error}")]
        else:
            yield from _alone(cluster, batch[:middle])
            yield from _alone(cluster, batch[middle:])


@contextmanager
def _dask_client(client: Client | None, workers: int | None) -> Iterator[Client]:
    if client is not None:
        yield client
        return
    from distributed import Client as NewClient
    from distributed import LocalCluster

    count = workers or os.cpu_count() or 1
    with (
        _no_main_module(),
        LocalCluster(
            n_workers=count, threads_per_worker=1, dashboard_address=None, silence_logs=logging.ERROR
        ) as cluster,
        NewClient(cluster) as own,
    ):
        yield own


@contextmanager
def _no_main_module() -> Iterator[None]:
    """Workers do not run the user's script again.

    Processes that multiprocessing spawns load the main module, and a script without `if __name__ == "__main__"` would then
    start another sweep in each worker. Our workers need nothing of it, so it is not named to them.
    """
    main = sys.modules["__main__"]
    spec, path = main.__spec__, getattr(main, "__file__", None)
    main.__spec__ = None
    main.__file__ = None
    try:
        yield
    finally:
        main.__spec__ = spec
        if path is None:
            del main.__file__
        else:
            main.__file__ = path


def on_ray(batches: Iterator[Batch], workers: int | None) -> Done:
    """On a Ray cluster: the one that runs, else one of this machine. Ray plans batches of a worker that dies again."""
    import ray

    is_own = not ray.is_initialized()
    if is_own:
        ray.init(num_cpus=workers, include_dashboard=False, log_to_driver=False, logging_level=logging.ERROR)
    try:
        remote = ray.remote(num_cpus=1, max_retries=3)(compute)
        running: dict[Any, Batch] = {}

        def fill() -> None:
            most = _AHEAD * max(1, int(ray.cluster_resources().get("CPU", 1)))
            while len(running) < most and (batch := next(batches, None)) is not None:
                running[remote.remote(batch)] = batch

        fill()
        while running:
            (done, *_), _ = ray.wait(list(running), num_returns=1)
            batch = running.pop(done)
            try:
                rows: list[Row] = ray.get(done)
            except ray.exceptions.WorkerCrashedError as error:
                rows = [lost(job, f"every worker that planned its batch died: {error}") for job in batch]
            yield batch, rows
            fill()
    finally:
        if is_own:
            ray.shutdown()
