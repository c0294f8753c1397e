#!/usr/bin/env python3
"""Pairtrawl's optimizer and CasADi's IPOPT and fatrop on the same joint problems, from the same starts, judged by the same `check`."""

import argparse
import datetime
import itertools
import json
import math
import os
import platform
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

os.environ.update(OMP_NUM_THREADS="1", RAYON_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")

import casadi

from scene import cost, read_scene
from solve import margin_price, solve, start_of, write_plan

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")) / "release" / "pairtrawl"
AGAIN = PROGRAM.parent / "examples" / "solve_again"
# A peer's results count as equally good within this; of those the faster one stands for it.
EQUAL = 1e-4
# Identical runs of a peer in one way; the least processor time counts. One is enough on a quiet machine.
REPEATS = 1
# First barrier parameters: IPOPT's own default, and a smaller one that stays nearer to the start.
BARRIERS = (0.1, 0.01)
# What is compared with, and the ways to write the problem down for it.
PEERS = {"ipopt": ("slip", "steps"), "fatrop": ("stages",)}
# Our cost may be this much above the cheaper one's.
TOLERANCE = 1e-3


def cases(difficulties, seeds):
    """(name, scene file or arguments of `generate`, arguments of `plan`)."""
    given = [
        ("paper-experiment-200", "paper-experiment", ["--waypoints", "200"]),
        ("paper-experiment", "paper-experiment", []),
        ("paper-experiment-200-free", "paper-experiment", ["--waypoints", "200", "--net-length", "auto"]),
        ("paper-simulation", "paper-simulation", ["--net-length", "2.0"]),
        ("authors-simulation", "authors-simulation", ["--net-length", "2.0"]),
    ]
    given += [(f"witness-{k}", f"witness-{k}", []) for k in range(1, 10)]
    made = [
        (f"generated-{d}-{s}", ["--kind", "witness", "--difficulty", str(d), "--seed", str(s), "-n", "200"], [])
        for s in seeds
        for d in difficulties
    ]
    return given + made


def run(*command):
    return subprocess.run([str(c) for c in command], capture_output=True, text=True, check=False)


def valid(scene, plan):
    """Whether every claim holds, and the names of those that do not."""
    done = run(PROGRAM, "check", scene, plan, "--json")
    if done.returncode not in (0, 6):
        sys.exit(f"check ended with {done.returncode}: {done.stderr}")
    return done.returncode == 0, [c["name"] for c in json.loads(done.stdout)["claims"] if not c["holds"]]


def peer_results(solver, file, scene, plan, free, directory):
    """Every way from the same start; with margins that may give way only where none converges to a valid one."""
    results = []
    for elastic in (False, True):
        for formulation, mu in itertools.product(PEERS[solver], BARRIERS):
            length = None if free else plan["net_length"]
            for result in solve(scene, start_of(plan), length, formulation, elastic, {"mu_init": mu}, REPEATS, solver):
                write_plan(directory / "peer.json", plan, result)
                result["valid"], result["failed"] = valid(file, directory / "peer.json")
                results.append({k: v for k, v in result.items() if k not in ("left", "right")})
        if better(results):
            break
    return results


def better(results):
    """The fastest of the converged and valid results that cost least, or None.

    Where no path keeps the whole margin, a solver may stop at a point that is valid and optimal for nothing: not a result.
    """
    good = [r for r in results if r["valid"] and r["converged"]]
    if not good:
        return None
    least = min(r["cost"] for r in good)
    return min((r for r in good if r["cost"] <= least * (1 + EQUAL)), key=lambda r: r["seconds"])


def ours(file, scene, directory, arguments, repeats):
    """What `plan` makes of a scene, and the plan; or why there is none. From one start the time is the processor's, the least
    of identical solves; exploring, which uses all threads, it is that of the stages as `plan` reports them."""
    done = run(PROGRAM, "plan", file, "--no-rehearsal", "--json", "-o", directory, *arguments)
    if done.returncode:
        return {"cost": math.inf, "valid": False, "note": f"plan exits {done.returncode}: {done.stderr.strip()[-200:]}"}, None
    plan = json.loads((directory / "plan.json").read_text())
    stages = json.loads(done.stdout)["seconds"]
    # Exploring includes the routes that it starts from.
    seconds, iterations = stages["explore"] + stages["optimize"], plan["solver"]["iterations"]
    if "--no-explore" in arguments:
        free = ["auto"] if "auto" in arguments else []
        again = json.loads(run(AGAIN, file, directory / "plan.json", *free, repeats).stdout)
        seconds = again["seconds"]
        if again["iterations"] != iterations:
            sys.exit(f"{file}: {again['iterations']} iterations again, {iterations} in the plan: made in several attempts")
    total = cost(scene.planner, plan["left"], plan["right"], plan["net_length"])[0]
    if not math.isclose(total, plan["cost"]["total"], rel_tol=1e-9):
        sys.exit(f"{file}: J is {total} here and {plan['cost']['total']} in plan.json")
    return {
        "cost": total, "valid": valid(file, directory / "plan.json")[0], "seconds": seconds, "iterations": iterations,
        "net_length": plan["net_length"], "margin_price": margin_price(scene, plan["left"], plan["right"]),
        "shrunk_margins": len(plan.get("warnings", [])),
    }, plan  # fmt: skip


def compare(name, source, arguments, directory, repeats):
    """One row of the table."""
    directory.mkdir(parents=True, exist_ok=True)
    if isinstance(source, str):
        file = ROOT / "scenes" / source / "scene.toml"
    else:
        made = run(PROGRAM, "generate", *source, "-o", directory / "scene")
        if made.returncode:
            sys.exit(f"{name}: {made.stderr}")
        file = directory / "scene" / "scene.toml"
    row, scene = {"scene": name}, read_scene(file)
    row["explored"], _ = ours(file, scene, directory / "explored", arguments, 1)
    # One solve from one start, the very one that IPOPT gets.
    row["ours"], plan = ours(file, scene, directory / "ours", [*arguments, "--no-explore"], repeats)
    if plan is None:
        return row
    row["waypoints"] = len(plan["left"])
    free = "auto" in arguments
    for peer in PEERS:
        row[peer + "_runs"] = peer_results(peer, file, scene, plan, free, directory)
        row[peer] = better(row[peer + "_runs"])
    found = [row[peer] for peer in PEERS if row[peer]]
    if found:
        cheaper, faster = min(found, key=lambda r: r["cost"]), min(found, key=lambda r: r["seconds"])
        priced = cheaper["cost"] + cheaper["margin_price"]
        for mine, prefix in (("ours", ""), ("explored", "explored_")):
            row[prefix + "cost_ratio"] = row[mine]["cost"] / cheaper["cost"]
            row[prefix + "priced_ratio"] = (row[mine]["cost"] + row[mine]["margin_price"]) / priced
            row[prefix + "speedup"] = faster["seconds"] / row[mine]["seconds"]
    return row


HEAD = (
    "| scene | N | J ours | J explored | J IPOPT | J fatrop | ours/cheaper | explored/cheaper | same with missing margins "
    "| valid ours/explored/IPOPT/fatrop | s ours | s explored | s IPOPT | s fatrop | times faster than the faster "
    "| iterations ours/IPOPT/fatrop | ways |\n|" + "---|" * 17
)


def kind(result):
    """Which of the ways to use the peer this is."""
    mu = result["options"]["mu_init"]
    rounds = f", round {result['round']}" if result["round"] > 1 else ""
    return f"{result['formulation']}{' elastic' if result['elastic'] else ''}, mu {mu}{rounds}"


def yes(result):
    """Whether it is valid, for the table."""
    return "yes" if result and result["valid"] else "no"


def way(row, peer):
    """The way that stands for a peer, or why there is none."""
    if row[peer]:
        return f"{peer} {kind(row[peer])}"
    reasons = (
        f"{kind(r)}: {r['status'] if not r['converged'] else 'breaks ' + ', '.join(r['failed'])}" for r in row[peer + "_runs"]
    )
    return f"{peer} none ({'; '.join(reasons)})"


def line(row):
    """A row in Markdown."""
    o, e = row["ours"], row["explored"]
    if "note" in o:
        cells = ["", "no plan", f"{e['cost']:.2f}", "", "", "", "", "", f"no/{yes(e)}", "", "", "", "", "", "", o["note"]]
        return f"| {row['scene']} | {' | '.join(cells)} |"
    peers = [row[peer] for peer in PEERS]
    ratios = ("cost_ratio", "explored_cost_ratio", "explored_priced_ratio")
    cells = [
        str(row["waypoints"]), f"{o['cost']:.2f}", f"{e['cost']:.2f}", *(f"{p['cost']:.2f}" if p else "-" for p in peers),
        *(f"{row[r]:.5f}" if r in row else "-" for r in ratios),
        "/".join(yes(r) for r in (o, e, *peers)),
        f"{o['seconds']:.4f}", f"{e['seconds']:.2f}", *(f"{p['seconds']:.3f}" if p else "-" for p in peers),
        f"{row['speedup']:.0f}" if "speedup" in row else "-",
        "/".join(str(r["iterations"]) if r else "-" for r in (o, *peers)),
        "; ".join(way(row, peer) for peer in PEERS),
    ]  # fmt: skip
    return f"| {row['scene']} | {' | '.join(cells)} |"


def percent(rows, prefix, sign):
    """The rows whose ratio is beyond the tolerance, and by how much."""
    far = [r for r in rows if sign * (r[prefix + "cost_ratio"] - 1) > TOLERANCE]
    each = ", ".join(
        f"{r['scene']} ({100 * (r[prefix + 'cost_ratio'] - 1):+.2f} %; with missing margins {100 * (r[prefix + 'priced_ratio'] - 1):+.2f} %)"
        for r in far
    )
    return f"on {len(far)} ({each})" if far else "nowhere"


def summary(rows):
    """Medians and the rows where ours is worse."""
    both = [r for r in rows if "cost_ratio" in r]
    count = {peer: sum(bool(r.get(peer)) for r in rows) for peer in PEERS}
    text = [f"{len(rows)} scenes; valid: ours from one start on {sum(r['ours']['valid'] for r in rows)}, explored on "
            f"{sum(r['explored']['valid'] for r in rows)}, IPOPT (best of its ways) on {count['ipopt']}, fatrop (best of its "
            f"ways) on {count['fatrop']}."]  # fmt: skip
    for who, prefix in (("one start", ""), ("explored", "explored_")):
        if not both:
            break
        ratios, speedups = [r[prefix + "cost_ratio"] for r in both], [r[prefix + "speedup"] for r in both]
        text.append(
            f"{who}: median J ours/cheaper {statistics.median(ratios):.6f} (least {min(ratios):.5f}, greatest "
            f"{max(ratios):.5f}); median times faster than the faster {statistics.median(speedups):.0f} (least "
            f"{min(speedups):.1f}, greatest {max(speedups):.0f}). Costs more by over 0.1 % {percent(both, prefix, 1)}; costs "
            f"less by over 0.1 % {percent(both, prefix, -1)}."
        )
    for peer in PEERS:
        ratios = [r[peer]["seconds"] / r["ours"]["seconds"] for r in rows if r.get(peer)]
        if ratios:
            text.append(f"{peer}: {statistics.median(ratios):.0f} times our time at the median, least {min(ratios):.1f}.")
    return "\n\n".join(text)


def machine():
    """Processor, cores, versions and the day."""
    model = platform.processor() or platform.machine()
    try:
        for entry in Path("/proc/cpuinfo").read_text().splitlines():
            if entry.startswith("model name"):
                model = entry.split(":", 1)[1].strip()
                break
    except OSError:
        pass
    commit = run("git", "-C", ROOT, "rev-parse", "--short", "HEAD").stdout.strip() or "unknown"
    load = os.getloadavg()[0] if hasattr(os, "getloadavg") else math.nan
    return (
        f"{model}, {os.cpu_count()} cores (one process, one thread each), load {load:.1f} at the end; CasADi "
        f"{casadi.__version__}, Python {platform.python_version()}, commit {commit}, {datetime.date.today().isoformat()}"
    )


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--scenes", nargs="*", help="names, or parts of names, of the table's first column")
    parser.add_argument("--difficulties", nargs="*", type=int, default=list(range(1, 11)))
    parser.add_argument("--seeds", nargs="*", type=int, default=[1], help="of generated scenes, each difficulty")
    parser.add_argument("--repeats", type=int, default=7, help="our solves a scene; the least time counts")
    parser.add_argument("--json", type=Path, help="write every figure here; scenes that are there already are not run again")
    parser.add_argument("--markdown", type=Path, help="write the table here")
    args = parser.parse_args()
    chosen = [
        c for c in cases(args.difficulties, args.seeds) if not args.scenes or any(s in c[0] for s in args.scenes)
    ]
    if not chosen:
        parser.error(f"no scene is called {args.scenes}")
    for program in (PROGRAM, AGAIN):
        if not program.exists():
            sys.exit(f"{program} is missing: cargo build --release && cargo build --release -p pairtrawl --example solve_again")
    done = {}
    if args.json and args.json.exists():
        done = {row["scene"]: row for row in json.loads(args.json.read_text())["rows"]}
    rows = []
    print(HEAD, flush=True)
    with tempfile.TemporaryDirectory() as directory:
        for case in chosen:
            rows.append(done.get(case[0]) or compare(*case, Path(directory) / case[0], args.repeats))
            print(line(rows[-1]), flush=True)
            # Written as it goes: a run that is cut still leaves its rows.
            if args.json:
                args.json.write_text(json.dumps({"machine": machine(), "rows": rows}, indent=1))
            if args.markdown:
                table = "\n".join([HEAD, *map(line, rows)])
                args.markdown.write_text(f"{machine()}\n\n{table}\n\n{summary(rows)}\n")
    print(f"\n{summary(rows)}\n{machine()}")


if __name__ == "__main__":
    main()
