"""The runs on which both engines are compared, each as the JSON that `examples/drive.rs` of crates/execution reads."""

import json
import math
import subprocess
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
STEP_TIME = 0.25


def pair(half_gap, steps, turn, speed=0.2):
    """Both robots abreast of a midpoint that moves with a heading rate `turn(t)` (rad/s)."""
    x, y, heading = 0.0, 0.0, math.pi / 2
    left, right = [], []
    for i in range(steps + 1):
        side = (math.sin(heading), -math.cos(heading))
        left.append([x - half_gap * side[0], y - half_gap * side[1], heading])
        right.append([x + half_gap * side[0], y + half_gap * side[1], heading])
        rate = turn(i * STEP_TIME)
        middle = heading + 0.5 * rate * STEP_TIME
        x += speed * STEP_TIME * math.cos(middle)
        y += speed * STEP_TIME * math.sin(middle)
        heading += rate * STEP_TIME
    return left, right


def drive(name, half_gap, steps, turn, places, net_length):
    """A run along `turn` through cubes at `places`: (step of the path, offset to its right in m, mass in kg)."""
    left, right = pair(half_gap, steps, turn)
    objects = []
    for step, offset, mass in places:
        (x0, y0, _), (x1, y1, _) = left[step], right[step]
        part = 0.5 + 0.5 * offset / half_gap
        objects.append({"position": [x0 + part * (x1 - x0), y0 + part * (y1 - y0)], "size": [0.05, 0.05], "mass": mass})
    return {
        "name": name, "scene": {"obstacles": [], "objects": objects}, "net_length": net_length,
        "left": left, "right": right, "step_time": STEP_TIME,
    }


def from_plan(name, scene_file, plan_file):
    """A scene file and a plan file as a run."""
    with open(scene_file, "rb") as file:
        scene = tomllib.load(file)
    plan = json.loads(Path(plan_file).read_text())
    kept = {key: scene[key] for key in ("obstacles", "objects", "physics", "net") if key in scene}
    return {
        "name": name, "scene": kept, "net_length": plan["net_length"],
        "left": plan["left"], "right": plan["right"], "step_time": plan["step_time"],
    }


def built_in():
    """Straight, turn, clutter and two whole runs.

    Cubes stand beside each other's tracks: where one pushes a file of others straight ahead, the file buckles to a side that
    depends on the last digit, in every engine, and nothing can be compared afterwards.
    """
    file = [(8 + 4 * i, (0.09, -0.06, 0.02, -0.1, 0.06, 0.11, -0.02, -0.08)[i], 0.025) for i in range(8)]
    bend = [(10 + 5 * i, (0.08, -0.05, 0.1, 0.0, -0.09)[i], 0.025) for i in range(5)]
    clutter = [(10 + 2 * (i // 5), 0.06 * (i % 5) - 0.12 + 0.004 * i, 0.025) for i in range(20)]
    snake = [(10 + 10 * i, (0.08, -0.06, 0.1, -0.1, 0.02, 0.09, -0.08, 0.05)[i], 0.015 + 0.005 * i) for i in range(8)]
    arc = [(10 + 8 * i, (0.1, -0.1, 0.04, -0.05)[i % 4], 0.025) for i in range(10)]
    return [
        drive("straight", 0.3, 48, lambda t: 0.0, file, 1.5),
        drive("turn", 0.35, 48, lambda t: -0.12, bend, 1.6),
        drive("clutter", 0.35, 40, lambda t: 0.05 * math.sin(t), clutter, 2.0),
        drive("whole run, snake", 0.3, 100, lambda t: 0.15 * math.sin(0.4 * t), snake, 1.4),
        drive("whole run, half circle", 0.32, 96, lambda t: -0.2 / 1.5, arc, 1.8),
    ]


def varied():
    """Twenty short drives: turns of all kinds through clutter, and nets that are caught on a post.

    Everything follows from the number of the drive; cubes stand beside each other's tracks as in `built_in`.
    """
    runs = []
    for i in range(18):
        bend, wave = 0.05 * (i % 5 - 2), 0.04 * (i % 3)
        half_gap = 0.3 + 0.02 * (i % 4)
        places = [
            (8 + 3 * k, half_gap * (0.62 * ((k * 0.618 + 0.37 * i) % 1.0) - 0.31), 0.015 + 0.01 * ((k + i) % 4))
            for k in range(4 + i % 6)
        ]
        turn = lambda t, bend=bend, wave=wave: bend + wave * math.sin(1.3 * t)
        runs.append(drive(f"varied {i + 1}", half_gap, 40, turn, places, 1.5 + 0.1 * (i % 5)))
    for i, offset in enumerate((0.0, 0.05)):
        # The post passes between the robots and then holds the net.
        snag = drive(f"snag {i + 1}", 0.36, 24, lambda t: 0.0, [(6, -0.1, 0.025), (8, 0.12, 0.025)], 1.6)
        snag["scene"]["obstacles"] = [{"circle": [offset, 0.5, 0.04]}]
        runs.append(snag)
    return runs


def authors(folder):
    """The trajectories that the paper's authors published (comma-separated: left x, left y, right x, right y), through the cubes of the scenes."""
    runs = []
    for name, scene, net_length in (
        ("experiment_traj.csv", "paper-experiment", 2.0),
        ("simulation_traj.csv", "authors-simulation", 2.0),
    ):
        rows = [[float(x) for x in line.split(",")] for line in (Path(folder) / name).read_text().split()]
        places = resampled(rows, 0.05)
        with open(ROOT / "scenes" / scene / "scene.toml", "rb") as file:
            objects = tomllib.load(file)["objects"]
        left, right = (with_headings([row[k : k + 2] for row in places]) for k in (0, 2))
        runs.append({
            "name": name, "scene": {"obstacles": [], "objects": objects}, "net_length": net_length,
            "left": left, "right": right, "step_time": STEP_TIME,
        })
    return runs


def resampled(rows, step):
    """Rows at which the faster robot has gone another `step`."""
    kept, gone = [rows[0]], 0.0
    for before, row in zip(rows, rows[1:]):
        gone += max(math.dist(before[k : k + 2], row[k : k + 2]) for k in (0, 2))
        if gone >= step:
            kept.append(row)
            gone = 0.0
    return kept


def with_headings(places):
    """Poses that look along the chord between their neighbors, without jumps of a whole turn."""
    poses = []
    for i, (x, y) in enumerate(places):
        (x0, y0), (x1, y1) = places[max(i - 1, 0)], places[min(i + 1, len(places) - 1)]
        heading = math.atan2(y1 - y0, x1 - x0) if (x0, y0) != (x1, y1) else poses[-1][2]
        if poses:
            heading += math.tau * round((poses[-1][2] - heading) / math.tau)
        poses.append([x, y, heading])
    return poses


def build():
    """Builds `examples/drive.rs`."""
    command = ["cargo", "build", "--quiet", "--release", "-p", "pairtrawl-execution", "--example", "drive"]
    subprocess.run(command, cwd=ROOT, check=True)


def ours(scenario, **extra):
    """What `examples/drive.rs` prints for a run: its record as JSON, or an export."""
    program = ROOT / "target" / "release" / "examples" / "drive"
    text = json.dumps(scenario | extra)
    return subprocess.run([program], input=text, capture_output=True, text=True, cwd=ROOT, check=True).stdout
