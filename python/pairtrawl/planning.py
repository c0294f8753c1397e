"""Planning, checking, driving: the functions of `pairtrawl` by keyword."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from os import PathLike
from typing import TYPE_CHECKING, Any, Literal

from pairtrawl import _native
from pairtrawl._native import Plan, Scene
from pairtrawl.errors import InputError, PairtrawlError
from pairtrawl.progress import Progress, reporting
from pairtrawl.results import Certificate, Execution, LengthCurve, Rehearsal

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from pairtrawl.options import PlanOptions, RunOptions


def plan(
    scene: Scene, *, threads: int | None = None, progress: Progress = None, **options: Unpack[PlanOptions]
) -> Plan:
    """Plans a scene: the order of the objects, both trajectories and, unless it is given, the length of the net.

    A plan comes back only when every claim of its certificate holds. The same scene and options give the same plan, bit for
    bit, whatever the number of threads. The interpreter's lock is free meanwhile; Ctrl-C ends it.

    Options, all by keyword (`pairtrawl.options.PlanOptions`): net_length (m, or "auto"), waypoints, order ("shortest" or
    "given"), orders, explore, centerline ("hybrid-a-star" or "rrt-star"), method ("joint", "alternating" or
    "alternating-bounded"), tolerance, seed, time_limit (s), leave ("none" or "unreachable"), rehearsal ("skip", "report" or "require"),
    rounds, rehearsal_rounds.

    threads: how many threads work; None: as many as the machine has.
    progress: True for a bar, or a callback that takes `ProgressEvent`s.

    Raises InputError, InfeasibleError (with proofs), NoPlanError (with the claim that fails) or TimeLimitError.
    """
    with reporting(progress, what=scene.name) as report:
        return _native.plan(scene, dict(options), threads, report)


def replan(
    before: Plan,
    scene: Scene,
    *,
    passed: int = 0,
    threads: int | None = None,
    progress: Progress = None,
    **options: Unpack[PlanOptions],
) -> Plan:
    """Plans a scene that has changed since `before` was planned: an obstacle moved, or the robots are on their way.

    The scene starts where the robots are and lists what is still to be gathered. `passed` is the last waypoint of `before`
    that the pair has passed: `before.waypoint_at(seconds)`. The net keeps its length. Options and errors as those of `plan`.
    """
    with reporting(progress, what=scene.name) as report:
        return _native.replan(before, scene, passed, dict(options), threads, report)


def plan_batch(
    scenes: Iterable[Scene],
    *,
    each: Sequence[Mapping[str, Any]] | None = None,
    errors: Literal["return", "raise"] = "return",
    threads: int | None = None,
    progress: Progress = None,
    **options: Unpack[PlanOptions],
) -> list[Plan | PairtrawlError]:
    """Plans many scenes in parallel on the threads of this machine.

    The results come in the order of the scenes, each with the same bits as if it was planned alone. Where there is no plan its
    exception stands instead, unless `errors` is "raise": then the first one is raised once all are done.

    each: options of each scene, besides those that all share.
    """
    batch = list(scenes)
    own = [dict(one) for one in each] if each is not None else [{} for _ in batch]
    if len(own) != len(batch):
        raise InputError(f"there are {len(batch)} scenes, but options for {len(own)}")
    joined = [{**options, **one} for one in own]
    with reporting(progress, total=len(batch), what="planning") as report:
        results = _native.plan_batch(batch, joined, threads, report)
    if errors == "raise":
        for result in results:
            if isinstance(result, PairtrawlError):
                raise result
    return results


def check(scene: Scene, plan: Plan) -> Certificate:
    """Proves a plan again from the scene and the two trajectories alone; nothing else that the plan says is believed."""
    return _native.check(scene, plan)


def rehearse(
    scene: Scene, plan: Plan, *, time_step: float | None = None, frame_interval: float | None = None
) -> Rehearsal:
    """Drives a plan closely in physics, with the real net, objects and contacts. What comes out is no proof.

    time_step: of the physics, s, 0.01 by default. frame_interval: between two instants that are kept, s, 0.1 by default.
    """
    return _native.rehearse(scene, plan, time_step=time_step, frame_interval=frame_interval)


def run(
    scene: Scene,
    plan: Plan,
    *,
    output: str | PathLike[str] | None = None,
    threads: int | None = None,
    progress: Progress = None,
    **options: Unpack[RunOptions],
) -> Execution:
    """Lets controllers drive a plan in physics, in trials with noise, delay and unknown loads.

    Options, all by keyword (`pairtrawl.options.RunOptions`): controller ("mrac", "integral" or "model-based"), trials, seed,
    robot_mass, robot_inertia, object_mass (kg), payload (kg), friction, pose_delay (s), velocity_delay (s), odometry_scale,
    position_noise (m), heading_noise (rad), feedback, rates, adapt, torque_limit (N m), stop_error (m), nominal_inertia ("table" or
    "robot"), sample_interval (s), unproven. Ranges are a number or a pair.

    output: a folder for execution.json, report.html and a ROS 2 recording of the first trial, as from the program.
    """
    total = options.get("trials") or 5
    with reporting(progress, total=total, what="driving") as report:
        return _native.run(scene, plan, dict(options), output, threads, report)


def length_curve(
    scene: Scene,
    *,
    start: float | None = None,
    stop: float | None = None,
    points: int | None = None,
    threads: int | None = None,
    progress: Progress = None,
    **options: Unpack[PlanOptions],
) -> LengthCurve:
    """The cost of the best plan over the length of the net, with route and sides fixed, and the optimum with the length free.

    start, stop: the range of lengths, m; points: how many, both ends included, 21 by default. Options as those of `plan`.
    """
    with reporting(progress, what=scene.name) as report:
        return _native.length_curve(scene, start, stop, points, dict(options), threads, report)


def generate(
    kind: Literal["witness", "serpentine", "hall", "litter"] = "witness",
    *,
    seed: int = 0,
    difficulty: int = 5,
    waypoints: int = 200,
    size: tuple[float, float] = (15.0, 10.0),
    boxes: int = 3,
    objects: int = 12,
    near: float = 0.62,
    map: str | PathLike[str] | None = None,
) -> Scene:
    """Makes a scene; the same arguments give the same one.

    kind: "witness" (free bends) and "serpentine" (lanes in a hall) are solvable by construction, with a `difficulty` from 1 to
    10 and a known solution of so many `waypoints`, about 4 cm each. "hall" (an open hall of `size`, m, with `boxes`) and
    "litter" (on the floor of the ROS map `map`) scatter `objects` as litter lies, at least `near` m from walls: solvable or not.
    """
    if kind in ("witness", "serpentine"):
        return _native.generate_solvable(kind, difficulty, seed, waypoints)
    if kind == "hall":
        return _native.generate_hall(size, boxes, objects, near, seed)
    if kind != "litter":
        raise InputError(f"kind is {kind!r}, it must be 'witness', 'serpentine', 'hall' or 'litter'")
    if map is None:
        raise InputError("kind='litter' needs a map: give the YAML file of a ROS map, or take kind='hall', which needs none")
    return _native.generate_litter(map, objects, near, seed)
