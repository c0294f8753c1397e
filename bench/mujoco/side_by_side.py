"""The rehearsal's physics beside MuJoCo on the same runs.

    pip install mujoco numpy
    python bench/mujoco/side_by_side.py [--varied] [--authors FOLDER] [SCENE.toml PLAN.json ...]

Without arguments: a straight drive, a turn, clutter and two whole runs; `--varied`: twenty short drives with turns, clutter and
snags; `--authors`: the trajectories that the paper's authors published, from a folder; with pairs of files: these plans.

Where a cube rides on another it may slip off or stay, and a millimeter at the start decides it, in every engine. Our run is
therefore repeated with all cubes moved by at most 2 mm, and MuJoCo's one run is compared with the run of ours that ends
nearest to it (run 0 is the one with no cube moved). Prints, per run, mean drive force of both robots, distance of the cubes'
ends (median and greatest), the same from MuJoCo's run to our run 0, the spread of our runs (median and greatest distance from
run 0), cubes gathered and simulated seconds per second, and fails when the force differs by more than 1 %, the median by more
than 10 mm or the counts at all.
"""

import copy
import json
import sys
from pathlib import Path

import numpy as np

import model
import scenarios
from scenarios import ours

FORCE, PLACE = 0.01, 0.010
# So many runs of ours with moved cubes, and how far each is moved at most along either axis, m.
MOVED_RUNS, MOVED = 12, 0.002


def moved(scenario, seed):
    """The run with its cubes moved a little; as it is with seed 0."""
    if seed == 0:
        return scenario
    other = copy.deepcopy(scenario)
    random = np.random.default_rng(seed)
    for thing in other["scene"].get("objects", []):
        thing["position"] = [p + float(d) for p, d in zip(thing["position"], random.uniform(-MOVED, MOVED, 2))]
    return other


class OurRun:
    """What a run of ours showed."""

    def __init__(self, scenario):
        record = json.loads(ours(scenario, frame_interval=0.05))
        # It stands still for half a second after its end; robots stop and set off at either end.
        end = record["duration"] - 0.5 - model.START
        self.force = np.mean([sum(f["drive_force"]) for f in record["frames"] if model.START < f["time"] < end])
        self.ends = np.array([o[:2] for o in record["frames"][-1]["objects"]])
        self.gathered = sum(record["gathered"])
        self.factor = record["real_time_factor"]


def distances(one, other):
    """Median and greatest distance of the cubes' ends, mm."""
    off = 1e3 * np.linalg.norm(np.array(one) - np.array(other), axis=1)
    return np.median(off), off.max()


def main():
    files = sys.argv[1:]
    runs = [] if files else scenarios.built_in()
    scenarios.build()
    if files[:1] == ["--varied"]:
        files = files[1:]
        runs += scenarios.varied()
    if files[:1] == ["--authors"]:
        runs += scenarios.authors(files[1])
        files = files[2:]
    for scene, plan in zip(files[::2], files[1::2]):
        runs.append(scenarios.from_plan(Path(scene).parent.name, scene, plan))
    failed = False
    print(
        f"{'run':24} {'force ours':>11} {'MuJoCo':>8} {'diff':>7} {'nearest':>8} {'median':>9} {'max':>9}"
        f" {'run 0: median, max':>20} {'our spread':>16} {'gathered':>9} {'x real time':>14}"
    )
    for scenario in runs:
        other = model.run(ours(scenario, export="mjcf"))
        mine = [OurRun(moved(scenario, seed)) for seed in range(1 + MOVED_RUNS)]
        apart = [distances(run.ends, other.objects) for run in mine]
        nearest = min(range(len(mine)), key=lambda i: apart[i])
        spread = [distances(run.ends, mine[0].ends) for run in mine[1:]]
        spread = np.median([median for median, _ in spread]), max(greatest for _, greatest in spread)
        best = mine[nearest]
        difference = best.force / other.drive_force.sum() - 1.0
        gathered = [best.gathered, sum(model.encloses(other.net, o) for o in other.objects)]
        good = abs(difference) < FORCE and apart[nearest][0] < 1e3 * PLACE and gathered[0] == gathered[1]
        failed |= not good
        print(
            f"{scenario['name']:24} {best.force:9.4f} N {other.drive_force.sum():6.4f} N {difference:+7.2%} {nearest:8}"
            f" {apart[nearest][0]:6.1f} mm {apart[nearest][1]:6.1f} mm {apart[0][0]:11.1f} {apart[0][1]:5.1f} mm"
            f" {spread[0]:7.1f} {spread[1]:5.1f} mm {gathered[0]:4}/{gathered[1]:<4}"
            f" {mine[0].factor:6.1f}/{other.factor:<6.1f}{'' if good else '  DIFFERS'}",
            flush=True,
        )
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
