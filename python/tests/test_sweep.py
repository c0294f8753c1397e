"""Sweeps: the same rows on every engine, whatever happens to the workers."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import cloudpickle
import numpy as np
import pandas as pd
import pytest
from distributed import Client, LocalCluster

import pairtrawl as pt
from conftest import ROOT
from pairtrawl.sweeping import engines, rows
from pairtrawl.sweeping.jobs import Job, grid

QUICK: dict[str, Any] = {"rehearsal": "skip", "explore": False}


@pytest.fixture(scope="module")
def client() -> Iterator[Client]:
    """A cluster of two workers with one thread each."""
    with (
        LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster,
        Client(cluster) as client,
    ):
        yield client


@pytest.fixture(scope="module")
def scenes() -> list[pt.Scene]:
    """Small scenes that are solvable by construction."""
    return [pt.generate(difficulty=1 + seed % 3, waypoints=80, seed=seed) for seed in range(6)]


def same(one: pd.DataFrame, other: pd.DataFrame) -> bool:
    """Equal bit for bit, but for the seconds."""
    return one.drop(columns="seconds").equals(other.drop(columns="seconds"))


def test_every_engine_gives_the_same_rows(client: Client, scenes: list[pt.Scene]) -> None:
    sweep = {"net_length": [0.4, 1.6], "seed": 3, **QUICK}
    table = pt.sweep(scenes, client=client, batch_size=2, **sweep)
    assert same(table, pt.sweep(scenes, engine="threads", **sweep))
    assert list(table["scene"]) == [scene.name for scene in scenes for _ in range(2)]
    assert list(table["net_length"]) == [0.4, 1.6] * len(scenes)
    short, long = table[::2], table[1::2]
    assert (short["error_type"] == "InfeasibleError").all() and short["total"].isna().all()
    assert short["error"].str.contains("proven infeasible").all()
    assert long["error"].isna().all() and long["valid"].all() and (long["gathered"] == long["objects"]).all()
    assert (table["seconds"] > 0).all() and (table["seed"] == 3).all()
    plan = pt.plan(scenes[0], net_length=1.6, seed=3, rehearsal="skip", explore=False)
    row = table.iloc[1]
    assert (row["digest"], row["total"], row["waypoints"]) == (plan.digest, plan.cost.total, len(plan))
    assert row["margin_separation"] == plan.certificate["separation"].margin


def test_every_claim_has_a_column(paper_plan: pt.Plan) -> None:
    names = {claim.name for claim in paper_plan.certificate}
    assert set(rows.CLAIMS) == names | {"robots_apart"}


def test_tables_and_files_of_scenes(client: Client) -> None:
    files = [ROOT / "scenes/paper-experiment/scene.toml"]
    table = pd.DataFrame({"net_length": [1.45, np.nan], "order": ["given", "shortest"]})
    result = pt.sweep(files, table=table, client=client, rehearsal="skip", explore=[False])
    assert list(result["order"]) == ["given", "shortest"]
    assert result["net_length"][0] == 1.45
    assert grid({"a": [1, 2], "b": 3}, [{"c": 4}]) == [{"c": 4, "a": 1, "b": 3}, {"c": 4, "a": 2, "b": 3}]
    for bad in ({"net_length": []}, {"batch_size": 0}, {"engine": "steam"}):
        with pytest.raises(pt.InputError):
            pt.sweep(files, **bad)
    assert pt.sweep([], engine="threads").empty


def test_an_unknown_option_is_an_error_and_no_row(client: Client, scenes: list[pt.Scene]) -> None:
    with pytest.raises(TypeError, match="did you mean net_length"):
        pt.sweep(scenes, client=client, net_lenght=[1.2])


def test_a_stopped_sweep_goes_on(scenes: list[pt.Scene], tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    counted: list[int] = []

    def count(batch: list[Job], threads: int | None = 1) -> list[rows.Row]:
        counted.append(len(batch))
        return rows.compute(batch, threads)

    def stop(event: pt.ProgressEvent) -> None:
        if len(counted) == 2:
            raise KeyboardInterrupt

    monkeypatch.setattr(engines, "compute", count)
    sweep: dict[str, Any] = {"engine": "threads", "batch_size": 2, "out": tmp_path, **QUICK}
    with pytest.raises(KeyboardInterrupt):
        pt.sweep(scenes, progress=stop, **sweep)
    assert counted == [2, 2]
    whole = pt.sweep(scenes, **sweep)
    assert counted == [2, 2, 2]
    # Nothing is left to do, whatever the size of batches; another option is new work.
    assert same(pt.sweep(scenes, **{**sweep, "batch_size": 5}), whole)
    assert counted == [2, 2, 2]
    pt.sweep(scenes[:1], seed=[1], **sweep)
    assert counted == [2, 2, 2, 1]
    monkeypatch.undo()
    assert same(pt.sweep(scenes, engine="threads", **QUICK), whole)
    assert len(pd.read_parquet(tmp_path)) == len(scenes) + 1


def test_what_is_no_part_of_a_sweep_is_refused(scenes: list[pt.Scene], tmp_path: Path) -> None:
    (tmp_path / "part-0.parquet").write_text("half a fi")
    with pytest.raises(pt.InputError, match=r"part-0\.parquet"):
        pt.sweep(scenes, engine="threads", out=tmp_path)


def test_scenes_of_a_generator_are_taken_when_a_worker_is_idle(client: Client) -> None:
    taken: list[int] = []

    def endless() -> Iterator[pt.Scene]:
        for seed in range(10_000):
            taken.append(seed)
            yield pt.generate(difficulty=1, waypoints=60, seed=seed)

    def stop(event: pt.ProgressEvent) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        pt.sweep(endless(), client=client, batch_size=1, progress=stop, **QUICK)
    assert len(taken) < 20


def test_a_worker_that_dies_loses_nothing(client: Client) -> None:
    scenes = [pt.generate(difficulty=2, waypoints=100, seed=seed) for seed in range(40)]
    killed: list[int] = []

    def kill(event: pt.ProgressEvent) -> None:
        if not killed:
            (pid,) = [pid for pid in client.run(os.getpid).values()][:1]
            killed.append(pid)
            os.kill(pid, signal.SIGKILL)

    table = pt.sweep(scenes, client=client, batch_size=4, progress=kill, **QUICK)
    assert killed
    assert table["error"].isna().all()
    assert same(table, pt.sweep(scenes, engine="threads", **QUICK))


def deadly(batch: list[Job], threads: int | None = 1) -> list[rows.Row]:
    """Kills its worker when a scene called `poison` is in the batch."""
    if any(job.scene.name == "poison" for job in batch):
        os._exit(1)
    return rows.compute(batch, threads)


def test_what_kills_every_worker_is_a_row(scenes: list[pt.Scene], monkeypatch: pytest.MonkeyPatch) -> None:
    cloudpickle.register_pickle_by_value(sys.modules[__name__])
    monkeypatch.setattr(engines, "compute", deadly)
    poison = scenes[0].copy()
    poison.name = "poison"
    with (
        LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=":0", silence_logs=50) as cluster,
        Client(cluster) as client,
    ):
        client.run_on_scheduler(lambda dask_scheduler: setattr(dask_scheduler, "allowed_failures", 0))
        table = pt.sweep([*scenes[:3], poison], client=client, batch_size=2, **QUICK)
    assert list(table["error"].isna()) == [True, True, True, False]
    assert "died" in table["error"].iloc[3]
    cloudpickle.unregister_pickle_by_value(sys.modules[__name__])


SCRIPT = """
import pairtrawl as pt
scene = pt.Scene.from_file("scenes/paper-experiment/scene.toml")
plan = pt.plan(scene)                       # options by keyword: net_length=1.45, waypoints=..., rehearsal=...
plan.left.shape, plan.net_length, plan.cost.total, pt.check(scene, plan).valid
table = pt.sweep([scene], net_length=[1.2, 1.45, 1.8])   # a DataFrame: scene, net_length, total, ..., error
print(list(table["net_length"]), table["error"].isna().all())
"""


def test_a_script_without_a_guard(tmp_path: Path) -> None:
    path = tmp_path / "script.py"
    path.write_text(SCRIPT)
    done = subprocess.run([sys.executable, path], cwd=ROOT, capture_output=True, text=True, timeout=300)
    assert done.stdout.strip() == "[1.2, 1.45, 1.8] True", done.stderr


def test_ray_gives_the_same_rows(scenes: list[pt.Scene]) -> None:
    pytest.importorskip("ray")
    table = pt.sweep(scenes, engine="ray", workers=2, batch_size=2, **QUICK)
    assert same(table, pt.sweep(scenes, engine="threads", **QUICK))


def test_the_client_may_be_used_from_a_thread(client: Client, scenes: list[pt.Scene]) -> None:
    tables: list[pd.DataFrame] = []
    thread = threading.Thread(target=lambda: tables.append(pt.sweep(scenes[:2], client=client, **QUICK)))
    begin = time.monotonic()
    thread.start()
    thread.join(120)
    assert len(tables) == 1 and time.monotonic() - begin < 120
