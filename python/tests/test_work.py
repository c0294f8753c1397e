"""Threads, signals, processes: nothing blocks, nothing crashes."""

from __future__ import annotations

import multiprocessing
import os
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import pytest

import pairtrawl as pt

LONG = {"difficulty": 9, "waypoints": 1500, "seed": 2}
"""A scene that takes seconds."""


def test_the_interpreter_runs_on_while_it_plans() -> None:
    scene = pt.generate(**LONG)
    ticks = 0
    planner = threading.Thread(target=lambda: pt.plan(scene, rehearsal="skip", explore=False))
    planner.start()
    while planner.is_alive():
        ticks += 1
        time.sleep(0.005)
    assert ticks > 20


def test_ctrl_c_ends_it() -> None:
    scene = pt.generate(**LONG)
    threading.Timer(0.2, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
    with pytest.raises(KeyboardInterrupt):
        pt.plan(scene)
    scenes = [scene.copy() for _ in range(6)]
    threading.Timer(0.2, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
    with pytest.raises(KeyboardInterrupt):
        pt.plan_batch(scenes)


def test_progress_comes_on_the_calling_thread(hall: pt.Scene) -> None:
    events: list[pt.ProgressEvent] = []
    threads = set()

    def note(event: pt.ProgressEvent) -> None:
        events.append(event)
        threads.add(threading.get_ident())

    plan = pt.plan(hall, progress=note)
    assert threads == {threading.get_ident()}
    begun = [event.stage for event in events if event.kind == "started"]
    assert begun[0] == "proofs" and begun[-1] == "rehearse"
    ended = {event.stage: event.seconds for event in events if event.kind == "finished"}
    assert set(ended) == set(plan.stages)
    events.clear()
    pt.plan_batch([hall, hall], progress=note, rehearsal="skip")
    assert sorted(event.index for event in events if event.index is not None) == [0, 1]


def test_an_exception_of_the_callback_ends_it(hall: pt.Scene) -> None:
    def refuse(event: pt.ProgressEvent) -> None:
        raise LookupError(event.kind)

    with pytest.raises(LookupError, match="started"):
        pt.plan(hall, progress=refuse)


def test_a_bar(hall: pt.Scene, capsys: pytest.CaptureFixture[str]) -> None:
    pt.plan(hall, progress=True)
    pt.plan_batch([hall], progress=True, rehearsal="skip")
    assert "small hall" in capsys.readouterr().err


def test_a_storm_of_threads(hall: pt.Scene) -> None:
    shared = hall.copy()

    def storm(index: int) -> str:
        shared.set_net(length=1.2 + 0.01 * (index % 3))
        plan = pt.plan(shared, rehearsal="skip", explore=False)
        assert plan.left is plan.left
        assert pt.check(plan.scene, plan).valid
        return f"{plan.net_length:.2f}"

    with ThreadPoolExecutor(16) as pool:
        lengths = set(pool.map(storm, range(64)))
    assert lengths <= {"1.20", "1.21", "1.22"}


def test_batches_come_in_order_with_the_same_bits(hall: pt.Scene) -> None:
    scenes = [pt.generate(difficulty=difficulty, waypoints=80, seed=5) for difficulty in (1, 3, 2)]
    narrow = hall.copy()
    narrow.set_net(length=0.5)
    results = pt.plan_batch([*scenes, narrow], rehearsal="skip", explore=False)
    assert isinstance(results[3], pt.InfeasibleError)
    assert results[3].seconds is not None and results[3].seconds > 0
    for scene, result in zip(scenes, results):
        assert isinstance(result, pt.Plan)
        assert result == pt.plan(scene, rehearsal="skip", explore=False)
    each = [{"net_length": 1.3}, {"net_length": 1.4}]
    lengths = [plan.net_length for plan in pt.plan_batch([hall, hall], each=each, rehearsal="skip") if isinstance(plan, pt.Plan)]
    assert lengths == [1.3, 1.4]
    with pytest.raises(pt.InfeasibleError):
        pt.plan_batch([narrow], errors="raise")
    with pytest.raises(pt.InputError, match="options for 1"):
        pt.plan_batch([hall, hall], each=[{}])
    assert pt.plan_batch([]) == []


def _plan_in_a_fork(scene: pt.Scene, answers: multiprocessing.Queue[str]) -> None:
    answers.put(pt.plan(scene, rehearsal="skip").digest)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="the system does not fork")
@pytest.mark.filterwarnings("ignore:.*fork.*:DeprecationWarning")
def test_a_forked_process_has_threads_of_its_own(hall: pt.Scene) -> None:
    expected = pt.plan(hall, rehearsal="skip").digest
    context = multiprocessing.get_context("fork")
    answers: multiprocessing.Queue[str] = context.Queue()
    child = context.Process(target=_plan_in_a_fork, args=(hall, answers))
    child.start()
    assert answers.get(timeout=60) == expected
    child.join(60)
    assert child.exitcode == 0


SUBINTERPRETER = """
try:
    import _interpreters as interpreters
except ImportError:
    import _xxsubinterpreters as interpreters
import pairtrawl
one = interpreters.create()
code = '''
try:
    import pairtrawl
except ImportError as error:
    print("refused:", error)
else:
    print("loaded")
'''
try:
    interpreters.run_string(one, code)
except Exception as error:
    print("raised", error)
interpreters.destroy(one)
print("alive", len(pairtrawl.generate(waypoints=80).objects) > 0)
"""


def test_a_subinterpreter_does_not_crash() -> None:
    done = subprocess.run([sys.executable, "-c", SUBINTERPRETER], capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    assert "alive True" in done.stdout
    assert "refused:" in done.stdout or "loaded" in done.stdout or "raised" in done.stdout


def test_planning_needs_numpy_alone() -> None:
    code = """
import sys
for name in ("pandas", "pyarrow", "dask", "distributed", "matplotlib", "tqdm", "ray"):
    sys.modules[name] = None
import pairtrawl as pt
print(pt.plan(pt.generate(difficulty=1, waypoints=80), rehearsal="skip").certificate.valid)
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120)
    assert done.stdout.strip() == "True", done.stderr
