#!/usr/bin/env python3
"""The joint problem of `crates/trajopt` solved by CasADi's IPOPT or fatrop: one plan from the baseline of another plan."""

import argparse
import json
import math
import os
import time

os.environ.setdefault("OMP_NUM_THREADS", "1")

import casadi as ca
import numpy as np

import distances as far
from program import ELASTIC_WEIGHT, LOOK_AHEAD, WIDE_LOOK_AHEAD, Rows, build, first_net_length, fixed_ends
from scene import cost, read_scene

# The same tolerance for both; those of IPOPT's that fatrop does not have are what IPOPT takes for solved.
OPTIONS = {
    "ipopt": {"tol": 1e-6, "acceptable_tol": 1e-6, "constr_viol_tol": 1e-7, "max_iter": 600, "max_cpu_time": 60.0,
              "linear_solver": "mumps", "print_level": 0, "sb": "yes"},
    "fatrop": {"tol": 1e-6, "tol_acceptable": 1e-6, "constr_viol_tol": 1e-7, "max_iter": 600, "print_level": 0},
}  # fmt: skip

# Solves at most: rows that turn out to be missing are added and IPOPT starts again from where it ended.
ROUNDS = 3
# Solves that take longer are not repeated, s.
LONG = 2.0


def solve(scene, start, net_length, formulation="slip", elastic=False, options=None, repeats=1, solver="ipopt"):
    """Results of one or more solves from (left, right) poses (n, 2, 3), one a round.

    Rows are fixed while a solver runs. A result that breaks a row that was not among them is solved again from the same
    start with all that it came near to and a wider look; one that an object's row bends at a waypoint where the line between
    the robots no longer passes goes on from where it ended. `seconds` are summed over the rounds and are the processor's for
    the solver alone, its callbacks and linear algebra, no set-up: the least of `repeats` identical solves, unless they are long.
    """
    first = poses = fixed_ends(scene, start)
    rows = Rows()
    rows.add(scene, poses, LOOK_AHEAD)
    rows.pin(scene, poses)
    length = first_net_length(poses, scene.planner) if net_length is None else net_length
    chosen = {solver: OPTIONS[solver] | (options or {}), "print_time": False}
    results, seconds, evaluation, iterations = [], 0.0, 0.0, 0
    for _ in range(ROUNDS):
        begin = time.perf_counter()
        nlp, full, d_max = build(scene, poses, rows, net_length, length, formulation, elastic)
        w, g, given, names, structure = nlp.gathered(formulation == "stages")
        program = {"x": w, "f": nlp.f, "g": g}
        run = ca.nlpsol("solver", solver, program, chosen | (structure if solver == "fatrop" else {}))
        read = ca.Function("read", [w], [ca.horzcat(*full[0], *full[1]), d_max])
        set_up = time.perf_counter() - begin
        spent = math.inf
        for _ in range(repeats):
            begin = time.process_time()
            out = run(**given)
            spent = min(spent, time.process_time() - begin)
            if spent > LONG:
                break
        seconds += spent
        stats = run.stats()
        evaluation += sum(v for k, v in stats.items() if k.startswith("t_wall_nlp_"))
        iterations += stats["iter_count"]
        flat, found = read(out["x"])
        poses, length = np.array(flat).reshape(-1, 2, 3), float(found)
        results.append({
            "solver": solver, "formulation": formulation, "elastic": elastic, "options": options or {}, "round": len(results) + 1,
            "status": stats["return_status"], "converged": bool(stats["success"]), "seconds": seconds,
            "evaluation_seconds": evaluation, "set_up_seconds": set_up, "iterations": iterations,
            "variables": int(w.numel()), "constraints": int(g.numel()), "net_length": length,
            "cost": float(cost(scene.planner, poses[:, 0], poses[:, 1], length)[0]),
            "margin_price": margin_price(scene, poses[:, 0], poses[:, 1]),
            "left": poses[:, 0].tolist(), "right": poses[:, 1].tolist(),
        })  # fmt: skip
        if not stats["success"]:
            break
        sides = [k for k, name in enumerate(names) if name == "side"]
        bent = sides and np.abs(np.array(out["lam_g"]).ravel()[sides]).max() > 1e-2
        if rows.add(scene, poses, LOOK_AHEAD):
            poses = first
            rows.add(scene, poses, WIDE_LOOK_AHEAD)
            length = first_net_length(poses, scene.planner) if net_length is None else net_length
        elif not (bent and rows.pin(scene, poses)):
            break
    return results


def margin_price(scene, left, right):
    """What the missing margins cost at our solver's price: with J, what both minimize where margins may give way."""
    p, ops = scene.planner, far.Numbers
    (lx, ly), (rx, ry) = (np.asarray(r)[1:-1, :2].T for r in (left, right))
    missing = 0.0
    for x, y in ((lx, ly), (rx, ry)):
        for px, py, radius in scene.objects:
            missing += np.maximum(scene.radius + radius + p["clearance"] - far.to_point(ops, x, y, px, py), 0).sum()
        for piece in scene.pieces:
            missing += np.maximum(scene.radius + p["clearance"] - far.to_piece(ops, x, y, piece), 0).sum()
    for piece in scene.pieces:
        for corner in piece.vertices:
            gap = far.corner_to_line(ops, lx, ly, rx, ry, corner)
            missing += np.maximum(p["clearance"] + piece.radius - gap, 0).sum()
    return float(ELASTIC_WEIGHT * missing)


def start_of(plan):
    """The baseline that a plan was optimized from, (n, 2, 3)."""
    return np.stack([np.array(plan["baseline"][s], float) for s in ("left", "right")], axis=1)


def write_plan(path, plan, result):
    """Writes what `pairtrawl check` needs, with the overrides of the plan that the start came from."""
    fields = {k: result[k] for k in ("net_length", "left", "right")}
    with open(path, "w") as file:
        json.dump({"format": "pairtrawl-plan/1", **fields, "step_time": plan["step_time"],
                   "scene": plan["scene"], "overrides": plan["overrides"]}, file)  # fmt: skip


def number(text):
    """A number where the text is one."""
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scene")
    parser.add_argument("plan", help="plan.json that `pairtrawl plan` wrote; its baseline is the start")
    parser.add_argument("-o", "--output", default="ipopt-plan.json")
    parser.add_argument("--free-length", action="store_true")
    parser.add_argument("--formulation", choices=("slip", "steps", "stages"), default="slip")
    parser.add_argument("--solver", choices=tuple(OPTIONS), default="ipopt", help="fatrop needs --formulation stages")
    parser.add_argument("--elastic", action="store_true", help="margins may give way at our solver's price")
    parser.add_argument("--option", action="append", default=[], help="of the solver, name=value")
    args = parser.parse_args()
    with open(args.plan) as file:
        plan = json.load(file)
    options = {name: number(value) for name, value in (o.split("=") for o in args.option)}
    length = None if args.free_length else plan["net_length"]
    scene = read_scene(args.scene)
    *_, result = solve(scene, start_of(plan), length, args.formulation, args.elastic, options,
                       solver=args.solver)
    write_plan(args.output, plan, result)
    print({k: v for k, v in result.items() if k not in ("left", "right")})


if __name__ == "__main__":
    main()
