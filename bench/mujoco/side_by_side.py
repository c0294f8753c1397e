"""The rehearsal's physics beside MuJoCo on the same runs.

    pip install mujoco numpy
    python bench/mujoco/side_by_side.py [SCENE.toml PLAN.json ...]

Without arguments: a straight drive, a turn, clutter and two whole runs; with pairs of files: these plans. Prints, per run,
mean drive force of both robots, distance of the cubes' ends (median and greatest), cubes gathered and simulated seconds per second,
and fails when the force differs by more than 1 %, the median by more than 10 mm or the counts at all.
"""

import json
import sys
from pathlib import Path

import numpy as np

import model
import scenarios
from scenarios import ours

FORCE, PLACE = 0.01, 0.010


def main():
    files = sys.argv[1:]
    runs = [] if files else scenarios.built_in()
    for scene, plan in zip(files[::2], files[1::2]):
        runs.append(scenarios.from_plan(Path(scene).parent.name, scene, plan))
    failed = False
    print(f"{'run':24} {'force ours':>11} {'MuJoCo':>8} {'diff':>7} {'median':>9} {'max':>9} {'gathered':>9} {'x real time':>14}")
    for scenario in runs:
        mine = json.loads(ours(scenario, frame_interval=0.05))
        other = model.run(ours(scenario, export="mjcf"))
        # Our run stands still for half a second after its end; robots stop and set off at either end.
        end = mine["duration"] - 0.5 - model.START
        force = np.mean([sum(f["drive_force"]) for f in mine["frames"] if model.START < f["time"] < end])
        difference = force / other.drive_force.sum() - 1.0
        ends = np.array([o[:2] for o in mine["frames"][-1]["objects"]])
        off = np.linalg.norm(ends - np.array(other.objects), axis=1)
        gathered = [sum(mine["gathered"]), sum(model.encloses(other.net, o) for o in other.objects)]
        good = abs(difference) < FORCE and np.median(off) < PLACE and gathered[0] == gathered[1]
        failed |= not good
        print(
            f"{scenario['name']:24} {force:9.4f} N {other.drive_force.sum():6.4f} N {difference:+7.2%}"
            f" {1e3 * np.median(off):6.1f} mm {1e3 * off.max():6.1f} mm {gathered[0]:4}/{gathered[1]:<4}"
            f" {mine['real_time_factor']:6.1f}/{other.factor:<6.1f}{'' if good else '  DIFFERS'}",
            flush=True,
        )
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
