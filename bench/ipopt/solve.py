#!/usr/bin/env python3
"""The joint problem of `crates/trajopt` for CasADi + IPOPT: one plan from the baseline of another plan."""

import argparse
import json
import math
import os
import time

os.environ.setdefault("OMP_NUM_THREADS", "1")

import casadi as ca
import numpy as np

import distances as far
from scene import cost, read_scene

# Reserves beyond the claims, as in `Problem::new`.
SEPARATION, NET_REACH, SKEW, SAG = 1e-3, 5e-4, 6e-3, 1.4e-3
# Kept within the limits of steps and turns: a claim holds to 1e-9, IPOPT to its tolerance.
ROUNDING = 2e-6
# Objects and obstacles are in play up to this far beyond what is kept from them, m. Wider than ours (0.35 m, looked up
# anew in every iteration), since rows here are fixed while IPOPT runs.
LOOK_AHEAD = 0.6
WIDE_LOOK_AHEAD = 2.0
# Price of a meter of margin that gives way, as in `Settings::default`.
ELASTIC_WEIGHT = 3e3
# Solves at most: rows that turn out to be missing are added and IPOPT starts again from where it ended.
ROUNDS = 3
# Solves that take longer are not repeated, s.
LONG = 2.0
# Beyond this share of a branch J_e goes on as a polynomial, as in `costs/expansion.rs`.
LIMIT = 0.97


class Rows:
    """Which objects and corners are in play, at which waypoint: sets of (waypoint, ...) tuples."""

    def __init__(self):
        self.objects, self.pieces, self.corners, self.sides = set(), set(), set(), set()

    def add(self, scene, poses, look_ahead):
        """Adds what is nearer than `look_ahead`; true when a row was missing that the poses break."""
        clearance = scene.planner["clearance"]
        keep = scene.radius + clearance
        ops, inner = far.Numbers, np.arange(1, len(poses) - 1)
        missing = False

        def near(into, values, *key):
            nonlocal missing
            for i in inner[values[inner] < look_ahead]:
                if (int(i), *key) not in into:
                    into.add((int(i), *key))
                    # With margins that give way, a missing row may break by as much as they do.
                    missing |= bool(values[i] < SAG - clearance)

        for robot in (0, 1):
            x, y = poses[:, robot, 0], poses[:, robot, 1]
            for k, (px, py, radius) in enumerate(scene.objects):
                near(self.objects, far.to_point(ops, x, y, px, py) - keep - radius, robot, k)
            for k, piece in enumerate(scene.pieces):
                near(self.pieces, far.to_piece(ops, x, y, piece) - keep, robot, k)
        (lx, ly), (rx, ry) = poses[:, 0, :2].T, poses[:, 1, :2].T
        for k, piece in enumerate(scene.pieces):
            for corner, place in enumerate(piece.vertices):
                gap = far.corner_to_line(ops, lx, ly, rx, ry, place) - clearance - piece.radius
                near(self.corners, gap, k, corner)
        return missing

    def pin(self, scene, poses):
        """Pins each object to the waypoint at which the line passes over it; true when that changed."""
        sides = {(crossing(poses, o[:2]), k) for k, o in enumerate(scene.objects)}
        changed = sides != self.sides
        self.sides = sides
        return changed


def crossing(poses, place):
    """The waypoint at which the line between the robots passes over an object, as in `refresh_crossings`."""
    l, r = poses[1:-1, 0, :2], poses[1:-1, 1, :2]
    rung = l - r
    length = np.hypot(*rung.T)
    q = place - r
    along = (q * rung).sum(1) / length
    ahead = np.abs(q[:, 0] * rung[:, 1] - q[:, 1] * rung[:, 0]) / length
    return 1 + int(np.argmin(ahead + 4 * np.maximum(np.maximum(-along, along - length), 0)))


def first_net_length(poses, planner):
    """As `first_net_length` in `optimise.rs`."""
    d = np.hypot(*(poses[:, 0, :2] - poses[:, 1, :2]).T)
    return max(d.mean() / planner["rest_ratio"], 1.2 * d.max())


def fixed_ends(scene, poses):
    """The start with the scene's ends; headings keep the turn count."""
    poses = poses.copy()
    for i, ends in ((0, scene.start), (-1, scene.end)):
        turns = np.round((poses[i, :, 2] - ends[:, 2]) / math.tau)
        poses[i] = ends
        poses[i, :, 2] += turns * math.tau
    return poses


class Program:
    """Variables, costs and constraints as they are gathered."""

    def __init__(self):
        self.w, self.w0, self.lw, self.uw = [], [], [], []
        self.g, self.lg, self.ug, self.names = [], [], [], []
        self.f = 0

    def variable(self, name, value, low=-math.inf, high=math.inf):
        value = np.atleast_1d(np.asarray(value, float)).ravel(order="F")
        symbol = ca.SX.sym(name, len(value))
        self.w.append(symbol)
        self.w0.append(value)
        self.lw.append(np.full(len(value), low))
        self.uw.append(np.full(len(value), high))
        return symbol

    def subject_to(self, name, low, column, high=math.inf):
        self.g.append(column)
        self.lg.append(np.full(column.numel(), low))
        self.ug.append(np.full(column.numel(), high))
        self.names.append((name, column.numel()))


def expansion(d, d_max, p):
    """J_e of a column of separations; both branches go on as polynomials near their poles."""
    rho, sigma = p["rest_ratio"], p["min_ratio"]
    eta = d / d_max

    def extended(function, t):
        z = ca.SX.sym("z")
        f0 = function(z)
        f1 = ca.gradient(f0, z)
        f2 = ca.gradient(f1, z)
        at = [float(ca.Function("at", [z], [f])(LIMIT)) for f in (f0, f1, f2)]
        u = ca.fmax(t - LIMIT, 0)
        clipped = ca.fmin(t, LIMIT)
        return ca.if_else(t <= LIMIT, function(clipped), at[0] + u * (at[1] + 0.5 * u * at[2]))

    inner = p["kd1"] * extended(lambda t: ca.tan(0.5 * math.pi * t) ** 2, (rho - eta) / (rho - sigma))
    outer = extended(lambda q: (q / (1 - q)) ** 2, (eta - rho) / (1 - rho)) + p["kd2"] * (d - rho * d_max) ** 2
    return p["a4"] * ca.if_else(eta < rho, inner, outer)


def build(scene, poses, rows, net_length, length_start, formulation, elastic):
    """The nonlinear program. `formulation`: 'slip' (poses, slip as equality) or 'steps' (steps and turns as variables)."""
    p, n, nlp = scene.planner, len(poses), Program()
    d_max = nlp.variable("d_max", length_start, 0.1, 50.0) if net_length is None else ca.SX(net_length)
    full = []  # x, y, heading columns of each robot, ends included
    for robot in (0, 1):
        columns = []
        for k in range(3):
            value = poses[:, robot, k]
            low, high = -math.inf, math.inf
            if k < 2:
                low, high = scene.area[0][k] + 1e-6, scene.area[1][k] - 1e-6
            inner = nlp.variable(f"z{robot}{k}", value[1:-1], low, high)
            columns.append(ca.vertcat(value[0], inner, value[-1]))
        full.append(columns)
    step, turn = p["max_step"] - ROUNDING, p["max_turn"] - ROUNDING
    for robot, (x, y, h) in enumerate(full):
        dx, dy, dh = (c[1:] - c[:-1] for c in (x, y, h))
        psi = 0.5 * (h[1:] + h[:-1])
        start = np.diff(poses[:, robot], axis=0)
        middle = 0.5 * (poses[1:, robot, 2] + poses[:-1, robot, 2])
        # dphi = u - v with both non-negative: |dphi| = u + v at the optimum, without smoothing.
        u = nlp.variable("u", np.maximum(start[:, 2], 0), 0, turn)
        v = nlp.variable("v", np.maximum(-start[:, 2], 0), 0, turn)
        nlp.subject_to("turn", 0, dh - u + v, 0)
        if formulation == "slip":
            along = dx * ca.cos(psi) + dy * ca.sin(psi)
            nlp.subject_to("slip", 0, dy * ca.cos(psi) - dx * ca.sin(psi), 0)
            nlp.subject_to("step", 0, along, step)
        else:
            value = start[:, 0] * np.cos(middle) + start[:, 1] * np.sin(middle)
            along = nlp.variable("s", np.clip(value, 0, step), 0, step)
            nlp.subject_to("x", 0, dx - along * ca.cos(psi), 0)
            nlp.subject_to("y", 0, dy - along * ca.sin(psi), 0)
        nlp.f += p["a2"] * (p["t1"] * ca.sum1(along) + p["t2"] * ca.sum1(u + v))
        for c, b in ((x, "b1"), (y, "b2"), (h, "b3")):
            nlp.f += p["a1"] * p[b] * ca.sumsqr(c[2:] - 2 * c[1:-1] + c[:-2])

    (lx, ly, lh), (rx, ry, rh) = full
    ex, ey = lx - rx, ly - ry
    d = ca.sqrt(ex**2 + ey**2)
    nlp.f += ca.sum1(expansion(d, d_max, p))
    share = 0.0 if net_length is None else p["min_ratio"] * net_length
    nlp.subject_to("separation", max(share, 2 * scene.radius) + SEPARATION, d[1:-1])
    bounded = slice(0, n) if net_length is None else slice(1, n - 1)
    nlp.subject_to("separation", 1e-6, (d_max - d)[bounded])
    hx = ex - scene.hitch * (ca.cos(lh) - ca.cos(rh))
    hy = ey - scene.hitch * (ca.sin(lh) - ca.sin(rh))
    nlp.subject_to("net_reach", NET_REACH, (d_max - ca.sqrt(hx**2 + hy**2 + far.EPSILON))[bounded])
    for h in (lh, rh):
        value = (ey * ca.cos(h) - ex * ca.sin(h)) / d
        nlp.subject_to("abreast", math.cos(p["max_skew"] - SKEW), value[1:-1])

    def keep(name, value, bound):
        """value >= bound; with `elastic` the margin gives way at a price, what the claim needs does not."""
        if elastic:
            e = nlp.variable("e", np.zeros(value.numel()), 0, p["clearance"] - min(SAG, p["clearance"]))
            nlp.f += ELASTIC_WEIGHT * ca.sum1(e)
            value = value + e
        nlp.subject_to(name, bound, value)

    ops = far.Symbols
    for robot, (x, y, _) in enumerate(full):
        for k, (px, py, radius) in enumerate(scene.objects):
            at = sorted(i for i, r, o in rows.objects if (r, o) == (robot, k))
            if at:
                keep("object", far.to_point(ops, x[at], y[at], px, py), scene.radius + radius + p["clearance"])
        for k, piece in enumerate(scene.pieces):
            at = sorted(i for i, r, o in rows.pieces if (r, o) == (robot, k))
            if at:
                keep("obstacle", far.to_piece(ops, x[at], y[at], piece), scene.radius + p["clearance"])
    for k, piece in enumerate(scene.pieces):
        for corner, place in enumerate(piece.vertices):
            at = sorted(i for i, o, c in rows.corners if (o, c) == (k, corner))
            if at:
                gap = far.corner_to_line(ops, lx[at], ly[at], rx[at], ry[at], place)
                keep("net", gap, p["clearance"] + piece.radius)
    for i, k in sorted(rows.sides):
        px, py, radius = scene.objects[k]
        for (x, y, _), sign in ((full[0], 1), (full[1], -1)):
            out = sign * ((x[i] - px) * ex[i] + (y[i] - py) * ey[i]) / d[i]
            nlp.subject_to("side", 0.9 * (radius + scene.radius), out)
    return nlp, full, d_max


def solve(scene, start, net_length, formulation="slip", elastic=False, options=None, repeats=1):
    """Results of one or more solves from (left, right) poses (n, 2, 3), one a round.

    IPOPT's rows are fixed while it runs. A result that breaks a row that was not among them is solved again from the same
    start with all that it came near to and a wider look; one that an object's row bends at a waypoint where the line between
    the robots no longer passes goes on from where it ended. `seconds` are summed over the rounds and are the processor's for
    IPOPT alone, its callbacks and linear algebra, no set-up: the least of `repeats` identical solves, unless they are long.
    """
    first = poses = fixed_ends(scene, start)
    rows = Rows()
    rows.add(scene, poses, LOOK_AHEAD)
    rows.pin(scene, poses)
    length = first_net_length(poses, scene.planner) if net_length is None else net_length
    ipopt = {"tol": 1e-6, "acceptable_tol": 1e-6, "constr_viol_tol": 1e-7, "max_iter": 600, "max_cpu_time": 60.0,
             "linear_solver": "mumps", "print_level": 0, "sb": "yes"}  # fmt: skip
    ipopt.update(options or {})
    results, seconds, evaluation, iterations = [], 0.0, 0.0, 0
    for _ in range(ROUNDS):
        begin = time.perf_counter()
        nlp, full, d_max = build(scene, poses, rows, net_length, length, formulation, elastic)
        w = ca.vertcat(*nlp.w)
        program = {"x": w, "f": nlp.f, "g": ca.vertcat(*nlp.g)}
        solver = ca.nlpsol("solver", "ipopt", program, {"ipopt": ipopt, "print_time": False})
        read = ca.Function("read", [w], [ca.horzcat(*full[0], *full[1]), d_max])
        set_up = time.perf_counter() - begin
        given = {"x0": nlp.w0, "lbx": nlp.lw, "ubx": nlp.uw, "lbg": nlp.lg, "ubg": nlp.ug}
        given = {name: np.concatenate(parts) for name, parts in given.items()}
        spent = math.inf
        for _ in range(repeats):
            begin = time.process_time()
            out = solver(**given)
            spent = min(spent, time.process_time() - begin)
            if spent > LONG:
                break
        seconds += spent
        stats = solver.stats()
        evaluation += sum(v for k, v in stats.items() if k.startswith("t_wall_nlp_"))
        iterations += stats["iter_count"]
        flat, found = read(out["x"])
        poses, length = np.array(flat).reshape(-1, 2, 3), float(found)
        results.append({
            "formulation": formulation, "elastic": elastic, "options": options or {}, "round": len(results) + 1,
            "status": stats["return_status"], "converged": bool(stats["success"]), "seconds": seconds,
            "evaluation_seconds": evaluation, "set_up_seconds": set_up, "iterations": iterations,
            "variables": int(w.numel()), "constraints": int(sum(len(b) for b in nlp.lg)), "net_length": length,
            "cost": float(cost(scene.planner, poses[:, 0], poses[:, 1], length)[0]),
            "margin_price": margin_price(scene, poses[:, 0], poses[:, 1]),
            "left": poses[:, 0].tolist(), "right": poses[:, 1].tolist(),
        })  # fmt: skip
        if not stats["success"]:
            break
        bent = rows.sides and np.abs(np.array(out["lam_g"]).ravel()[-2 * len(rows.sides) :]).max() > 1e-2
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
    parser.add_argument("--formulation", choices=("slip", "steps"), default="slip")
    parser.add_argument("--elastic", action="store_true", help="margins may give way at our solver's price")
    parser.add_argument("--option", action="append", default=[], help="of IPOPT, name=value")
    args = parser.parse_args()
    with open(args.plan) as file:
        plan = json.load(file)
    options = {name: number(value) for name, value in (o.split("=") for o in args.option)}
    length = None if args.free_length else plan["net_length"]
    scene = read_scene(args.scene)
    *_, result = solve(scene, start_of(plan), length, args.formulation, args.elastic, options)
    write_plan(args.output, plan, result)
    print({k: v for k, v in result.items() if k not in ("left", "right")})


if __name__ == "__main__":
    main()
