"""Loads the MJCF and SDF exports with MuJoCo and libsdformat.

    pip install mujoco numpy;  apt-get install libsdformat-dev g++ pkg-config
    python bench/mujoco/check_exports.py

MJCF: loads, the keyframe puts net and robots where they belong, and ten simulated seconds of the plan keep the net tied.
SDF: libsdformat (12) reads it without an error and resolves its joints. What is not installed is named and skipped.
"""

import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import scenarios
from scenarios import ours

HERE = Path(__file__).resolve().parent


def scenario():
    """Every kind of obstacle and of object."""
    run = scenarios.built_in()[1]
    run["scene"]["obstacles"] = [
        {"box": [-3.0, 0.0, -2.5, 1.0]},
        {"circle": [-2.0, 2.0, 0.2]},
        {"polygon": [[3.0, 0.0], [4.0, 0.0], [4.0, 0.5], [3.5, 0.5], [3.5, 1.0], [3.0, 1.0]]},
    ]
    run["scene"]["objects"].append({"position": [0.9, 1.9], "radius": 0.03, "mass": 0.02})
    return run


def check_mjcf(run):
    try:
        import model
        import mujoco
        import numpy as np
    except ImportError:
        print("MJCF: skipped, PyPI mujoco is not installed")
        return True
    text = ours(run, export="mjcf")
    loaded = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(loaded)
    mujoco.mj_resetDataKeyframe(loaded, data, loaded.key("start").id)
    mujoco.mj_forward(loaded, data)
    gap = np.linalg.norm(data.site("net_end").xpos - data.site("right_ring").xpos)
    start = json.loads(ours(run))["frames"][0]
    links = len(start["net"]) - 1
    off = max(np.linalg.norm(data.body(f"link_{i}").xpos[:2] - start["net"][i]) for i in range(links))
    driven = model.run(text)
    good = gap < 1e-6 and off < 1e-6 and driven.gap < 2e-3
    print(
        f"MJCF: {loaded.nbody} bodies, keyframe {1e6 * off:.2f} um off, end of the net {1e6 * gap:.2f} um off its hitch,"
        f" {1e3 * driven.gap:.3f} mm after the run: {'good' if good else 'BAD'}"
    )
    return good


def check_sdf(run):
    if shutil.which("pkg-config") is None or subprocess.run(["pkg-config", "--exists", "sdformat12"]).returncode:
        print("SDF: skipped, libsdformat-dev (12) is not installed")
        return True
    flags = subprocess.run(["pkg-config", "--cflags", "--libs", "sdformat12"], capture_output=True, text=True, check=True)
    with tempfile.TemporaryDirectory() as folder:
        checker, file = Path(folder) / "check_sdf", Path(folder) / "run.sdf"
        subprocess.run(["c++", "-std=c++17", str(HERE / "check_sdf.cpp"), "-o", str(checker), *flags.stdout.split()], check=True)
        file.write_text(ours(run, export="sdf"))
        result = subprocess.run([str(checker), str(file)], capture_output=True, text=True)
    print("SDF:", result.stdout.strip().replace("\n", "; "), result.stderr.strip(), "good" if result.returncode == 0 else "BAD")
    return result.returncode == 0


def main():
    scenarios.build()
    run = scenario()
    return 0 if all([check_mjcf(run), check_sdf(run)]) else 1


if __name__ == "__main__":
    sys.exit(main())
