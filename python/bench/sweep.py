"""Compares a sweep on a Dask cluster of two workers with `plan_batch` on two threads, on the same generated scenes.

    python python/bench/sweep.py --scenes 10000 --kill

Prints a table: plans, seconds and plans a second of each, their ratio, memory of client and workers over time, and whether both
results are the same, bit for bit. `--kill` kills a worker when half of the plans are done. Both take turns in blocks, so that a
machine whose speed changes is fair to both.
"""

from __future__ import annotations

import argparse
import os
import signal
import time
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory

import pandas as pd
from distributed import Client, LocalCluster

import pairtrawl as pt
from pairtrawl.sweeping.engines import on_dask
from pairtrawl.sweeping.jobs import batches, jobs
from pairtrawl.sweeping.rows import row_of, schema
from pairtrawl.sweeping.store import Store

OPTIONS = {"rehearsal": "skip", "explore": False, "rounds": 2}
"""Quick plans: one start, no rehearsal."""


def scenes(count: int, first: int = 0) -> Iterator[pt.Scene]:
    """Scenes that are planned in some tens of milliseconds."""
    for seed in range(first, first + count):
        yield pt.generate(difficulty=1 + seed % 4, waypoints=80, seed=seed)


def memory(pids: list[int]) -> list[int]:
    """Resident memory of processes, MB; 0 of one that is gone."""
    sizes = []
    for pid in pids:
        try:
            pages = int(Path(f"/proc/{pid}/statm").read_text().split()[1])
        except OSError:
            pages = 0
        sizes.append(pages * os.sysconf("SC_PAGE_SIZE") >> 20)
    return sizes


def same(one: pd.DataFrame, other: pd.DataFrame) -> bool:
    """Equal bit for bit, but for the seconds."""
    return one.drop(columns="seconds").equals(other.drop(columns="seconds"))


def main() -> None:
    """Measures."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scenes", type=int, default=1000)
    parser.add_argument("--block", type=int, default=2000, help="plans after which the other one takes its turn")
    parser.add_argument("--batch", type=int, default=100, help="plans of a task")
    parser.add_argument("--kill", action="store_true")
    arguments = parser.parse_args()

    columns = schema([OPTIONS])
    seconds = {"sweep": 0.0, "plan_batch": 0.0}
    sizes: list[list[int]] = []
    killed: list[int] = []
    with (
        TemporaryDirectory() as out,
        LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None, silence_logs=50) as cluster,
        Client(cluster) as client,
    ):
        client.run(lambda: __import__("pairtrawl"))
        pids = list(client.run(os.getpid).values())
        stores = {"sweep": Store(columns, out), "plan_batch": Store(columns, None)}
        order: list[str] = []
        for first in range(0, arguments.scenes, arguments.block):
            todo = list(jobs(scenes(min(arguments.block, arguments.scenes - first), first), [OPTIONS]))
            order += [job.key for job in todo]
            for name in ("sweep", "plan_batch") if first // arguments.block % 2 == 0 else ("plan_batch", "sweep"):
                begin = time.perf_counter()
                if name == "plan_batch":
                    plans = pt.plan_batch([job.scene for job in todo], threads=2, **OPTIONS)
                    seconds[name] += time.perf_counter() - begin
                    # Its rows are for the comparison only.
                    stores[name].add([row_of(job, plan) for job, plan in zip(todo, plans)])
                    continue
                for _, rows in on_dask(batches(todo, arguments.batch), client, None):
                    stores[name].add(rows)
                    if arguments.kill and not killed and first >= arguments.scenes / 2:
                        killed.append(pids[0])
                        os.kill(pids[0], signal.SIGKILL)
                seconds[name] += time.perf_counter() - begin
            if killed and len(killed) == 1:
                pids = list(client.run(os.getpid).values())
                killed.append(0)
            sizes.append(memory([os.getpid(), *pids]))
        tables = {name: store.frame(order) for name, store in stores.items()}

    print(f"{arguments.scenes} scenes, {int(tables['sweep']['error'].notna().sum())} without a plan")
    for name, spent in seconds.items():
        print(f"  {name:<11} {spent:8.1f} s  {arguments.scenes / spent:7.1f} plans a second")
    print(f"  the sweep has {seconds['plan_batch'] / seconds['sweep']:.1%} of the throughput of plan_batch")
    print(f"  a worker was {'killed' if killed else 'not killed'}; same bits: {same(tables['sweep'], tables['plan_batch'])}")
    for part in range(0, len(sizes), max(1, len(sizes) // 10)):
        print(f"  after {(part + 1) * arguments.block:6} plans: client {sizes[part][0]} MB, workers {sizes[part][1:]} MB")


if __name__ == "__main__":
    main()
