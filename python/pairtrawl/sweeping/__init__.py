"""Sweeps: many scenes with many options, on all cores of a machine or of a cluster, one row a plan."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping
from os import PathLike
from typing import TYPE_CHECKING, Any, Literal

from pairtrawl._native import Scene
from pairtrawl.errors import InputError
from pairtrawl.progress import Progress, reporting
from pairtrawl.sweeping.engines import on_dask, on_ray, on_threads
from pairtrawl.sweeping.jobs import Job, SceneLike, batches, grid, jobs
from pairtrawl.sweeping.rows import schema
from pairtrawl.sweeping.store import Store

if TYPE_CHECKING:
    import pandas as pd
    from distributed import Client

__all__ = ["sweep"]


def sweep(
    scenes: SceneLike | Iterable[SceneLike],
    *,
    table: pd.DataFrame | Iterable[Mapping[str, Any]] | None = None,
    out: str | PathLike[str] | None = None,
    engine: Literal["dask", "ray", "threads"] = "dask",
    client: Client | None = None,
    workers: int | None = None,
    batch_size: int | None = None,
    progress: Progress = None,
    **parameters: Any,
) -> pd.DataFrame:
    """Plans every scene with every combination of options: one row a plan.

    scenes: scenes or their files; a generator is read as workers become idle.
    parameters: options of `plan`, each one value or several: `net_length=[1.2, 1.45], rehearsal="skip"` makes a grid.
    table: sets of options instead, or besides: a DataFrame or dictionaries with options as columns; empty cells are left out.
    out: a folder for Parquet files, one for each batch. A sweep that was stopped goes on where it was: what stands there is not
        planned again. `pandas.read_parquet(out)` reads it.
    engine: "dask": on `client`, a client of any cluster, or else on a LocalCluster of `workers` processes with one thread each;
        "ray": on a Ray cluster; "threads": on `workers` threads of this process. All give the same rows, bit for bit.
    batch_size: plans for each task, 200 by default; fewer where there is less to do, so that all workers have some.
    progress: True for a bar, or a callback that takes an event for each plan.

    The rows come in the order of scenes, then of options, with columns for the scene, the swept options, cost terms, net length,
    margins of all claims, gathered objects, a digest of the plan, seconds, and the error where there is no plan. What fails is
    a row as well; so is what kills its worker. The column `seconds` is the only one that differs between runs.
    """
    if batch_size is not None and not 1 <= batch_size <= 100_000:
        raise InputError(f"batch_size is {batch_size}, it must be from 1 to 100000")
    rows = None if table is None else _rows(table)
    options = grid(parameters, rows)
    if isinstance(scenes, (Scene, str, PathLike)):
        scenes = [scenes]
    if isinstance(scenes, (list, tuple)):
        total: int | None = len(scenes) * len(options)
    else:
        total = None
    store = Store(schema(options), out)
    order: list[str] = []
    size = batch_size or _fair_size(total, workers)
    todo = batches(_unknown(jobs(scenes, options), store, order), size)
    run = {
        "dask": lambda: on_dask(todo, client, workers),
        "ray": lambda: on_ray(todo, workers),
        "threads": lambda: on_threads(todo, workers),
    }
    if engine not in run:
        raise InputError(f"engine is {engine!r}, it must be 'dask', 'ray' or 'threads'")
    with reporting(progress, total=total, what="sweep") as report:
        for batch, computed in run[engine]():
            store.add(computed)
            for _ in batch if report else ():
                report(kind="done")  # type: ignore[misc]
    return store.frame(order)


def _unknown(all_jobs: Iterator[Job], store: Store, order: list[str]) -> Iterator[Job]:
    """The jobs whose rows are not there yet, each once; the keys of all go into `order`."""
    begun = set(store.keys)
    for job in all_jobs:
        order.append(job.key)
        if job.key not in begun:
            begun.add(job.key)
            yield job


def _rows(table: pd.DataFrame | Iterable[Mapping[str, Any]]) -> Iterable[Mapping[str, Any]]:
    records = getattr(table, "to_dict", None)
    listed: Iterable[Mapping[str, Any]] = table if records is None else records("records")  # type: ignore[assignment]
    return listed


def _fair_size(total: int | None, workers: int | None) -> int:
    """Plans for each task: enough that a task costs little, few enough that all workers have several."""
    if total is None:
        return 200
    each = total / (8 * (workers or os.cpu_count() or 1))
    return max(1, min(200, round(each)))
