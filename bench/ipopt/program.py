"""The joint problem of `crates/trajopt`, written down for CasADi: variables, costs, constraints, and which rows are in play."""

import math

import casadi as ca
import numpy as np

import distances as far

# Reserves beyond the claims, as in `Problem::new`.
SEPARATION, NET_REACH, SKEW = 1e-3, 5e-4, 1.6e-2
# Kept within the limits of steps and turns: a claim holds to 1e-9, IPOPT to its tolerance.
ROUNDING = 2e-6
# Objects and obstacles are in play up to this far beyond what is kept from them, m. Wider than ours (0.35 m, looked up
# anew in every iteration), since rows here are fixed while IPOPT runs.
LOOK_AHEAD = 0.6
WIDE_LOOK_AHEAD = 2.0
# Price of a meter of margin that gives way, as in `Settings::default`.
ELASTIC_WEIGHT = 3e3
# Beyond this share of a branch J_e goes on as a polynomial, as in `costs/expansion.rs`.
LIMIT = 0.97


def sag(scene):
    """What is kept even where margins give way, as in `Problem::new`."""
    return 1.4 * scene.planner["max_step"] ** 2 / (8 * scene.radius)


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
                    missing |= bool(values[i] < sag(scene) - clearance)

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


# Place of the net length among the states, behind two poses and the changes before them; of what is no state.
LENGTH, OTHER = 12, 13


class Program:
    """Variables, costs and constraints as they are gathered, each at a stage: a waypoint with the step from it."""

    def __init__(self):
        self.w, self.w0, self.lw, self.uw = [], [], [], []
        self.g, self.lg, self.ug, self.names = [], [], [], []
        # Stage of every variable and row, and which state that is or changes; the others come behind (`OTHER`).
        self.places, self.row_places = [], []
        self.f = 0

    def variable(self, name, value, low=-math.inf, high=math.inf, stages=None, state=OTHER):
        value = np.atleast_1d(np.asarray(value, float)).ravel(order="F")
        symbol = ca.SX.sym(name, len(value))
        self.w.append(symbol)
        self.w0.append(value)
        self.lw.append(np.full(len(value), low))
        self.uw.append(np.full(len(value), high))
        self.places += [(int(k), state) for k in (stages if stages is not None else np.zeros(len(value)))]
        return symbol

    def subject_to(self, name, low, column, high=math.inf, stages=None, state=OTHER):
        count = column.numel()
        self.g.append(column)
        self.lg.append(np.full(count, low))
        self.ug.append(np.full(count, high))
        self.names += [name] * count
        self.row_places += [(int(k), state) for k in (stages if stages is not None else np.zeros(count))]

    def gathered(self, staged):
        """Variables, rows, their bounds, values and names, and the structure of stages; `staged`: in the order of stages."""
        w, g = ca.vertcat(*self.w), ca.vertcat(*self.g)
        order, rows = np.arange(w.numel()), np.arange(g.numel())
        structure = {}
        if staged:
            order = np.array(sorted(order, key=lambda k: self.places[k]))
            rows = np.array(sorted(rows, key=lambda k: self.row_places[k]))
            last = max(stage for stage, _ in self.places)

            def count(places, is_state):
                per_stage = [0] * (last + 1)
                for stage, state in places:
                    per_stage[stage] += (state != OTHER) == is_state
                return per_stage

            structure = {"structure_detection": "manual", "N": last, "nx": count(self.places, True),
                         "nu": count(self.places, False), "ng": count(self.row_places, False)}  # fmt: skip
        given = {name: np.concatenate(parts)[order] for name, parts in
                 (("x0", self.w0), ("lbx", self.lw), ("ubx", self.uw))}  # fmt: skip
        given |= {name: np.concatenate(parts)[rows] for name, parts in (("lbg", self.lg), ("ubg", self.ug))}
        names = [self.names[k] for k in rows]
        return w[order.tolist()], g[rows.tolist()], given, names, structure


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
    """The nonlinear program: 'slip' (poses, slip as equality), 'steps' (steps and turns as variables), or 'stages' (see
    `of_stages`)."""
    n, nlp = len(poses), Program()
    staged, every = formulation == "stages", np.arange(n)
    if net_length is not None:
        d_max = ca.SX(net_length)
    elif staged:
        d_max = nlp.variable("d_max", np.full(n, length_start), 0.1, 50.0, every, LENGTH)
    else:
        d_max = nlp.variable("d_max", length_start, 0.1, 50.0)
    full = []  # x, y, heading columns of each robot, ends included
    for robot in (0, 1):
        columns = []
        for k in range(3):
            value = poses[:, robot, k]
            low, high = -math.inf, math.inf
            if k < 2:
                low, high = scene.area[0][k] + 1e-6, scene.area[1][k] - 1e-6
            inner = nlp.variable(f"z{robot}{k}", value[1:-1], low, high, every[1:-1], 3 * robot + k)
            columns.append(ca.vertcat(value[0], inner, value[-1]))
        full.append(columns)
    if staged and net_length is None:
        nlp.subject_to("d_max", 0, d_max[1:] - d_max[:-1], 0, every[:-1], LENGTH)
    of = of_stages if staged else of_columns
    for robot in (0, 1):
        of(nlp, scene, poses[:, robot], full[robot], robot, formulation)
    add_pair(nlp, scene, full, d_max, net_length)
    add_things(nlp, scene, full, rows, elastic)
    return nlp, full, d_max[0]


def limits(planner):
    """Of step and turn."""
    return planner["max_step"] - ROUNDING, planner["max_turn"] - ROUNDING


def of_columns(nlp, scene, poses, columns, _, formulation):
    """The steps of a robot, its driven distance, turns and bends, written for whole columns."""
    p, (step, turn), (x, y, h) = scene.planner, limits(scene.planner), columns
    dx, dy, dh = (c[1:] - c[:-1] for c in columns)
    psi = 0.5 * (h[1:] + h[:-1])
    start = np.diff(poses, axis=0)
    middle = 0.5 * (poses[1:, 2] + poses[:-1, 2])
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


def of_stages(nlp, scene, poses, columns, robot, _):
    """The same as an optimal control problem: states are the pose, the change of pose in the step before, and the net length;
    controls are the step and its turn to either side. The first pose is no state, since it is given; the last one is held
    where it has to be by rows of its own."""
    p, (step, turn), n = scene.planner, limits(scene.planner), len(poses)
    steps, start = np.arange(n - 1), np.diff(poses, axis=0)
    middle = 0.5 * (poses[1:, 2] + poses[:-1, 2])
    value = start[:, 0] * np.cos(middle) + start[:, 1] * np.sin(middle)
    along = nlp.variable("s", np.clip(value, 0, step), 0, step, steps)
    u = nlp.variable("u", np.maximum(start[:, 2], 0), 0, turn, steps)
    v = nlp.variable("v", np.maximum(-start[:, 2], 0), 0, turn, steps)
    psi = columns[2][:-1] + 0.5 * (u - v)
    changes = (along * ca.cos(psi), along * ca.sin(psi), u - v)
    nlp.f += p["a2"] * (p["t1"] * ca.sum1(along) + p["t2"] * ca.sum1(u + v))
    for k, (c, change, b) in enumerate(zip(columns, changes, ("b1", "b2", "b3"))):
        pose = 3 * robot + k
        before = nlp.variable(f"before{k}", start[:-1, k], stages=steps[1:], state=6 + pose)
        last = nlp.variable(f"last{k}", poses[-1, k], stages=[n - 1], state=pose)
        nlp.subject_to("pose", 0, ca.vertcat(c[1:-1], last) - c[:-1] - change, 0, steps, pose)
        nlp.subject_to("before", 0, before - change[:-1], 0, steps[:-1], 6 + pose)
        nlp.subject_to("end", poses[-1, k], last, poses[-1, k], [n - 1])
        nlp.f += p["a1"] * p[b] * ca.sumsqr(change[1:] - before)


def add_pair(nlp, scene, full, d_max, net_length):
    """The cost of the separation and what is asked of the pair at each waypoint."""
    p, every = scene.planner, np.arange(full[0][0].numel())
    (lx, ly, lh), (rx, ry, rh) = full
    ex, ey = lx - rx, ly - ry
    d = ca.sqrt(ex**2 + ey**2)
    nlp.f += ca.sum1(expansion(d, d_max, p))
    inner = every[1:-1]
    share = 0.0 if net_length is None else p["min_ratio"] * net_length
    nlp.subject_to("separation", max(share, 2 * scene.radius) + SEPARATION, d[1:-1], stages=inner)
    bounded = every if net_length is None else inner
    nlp.subject_to("separation", 1e-6, (d_max - d)[bounded.tolist()], stages=bounded)
    hx = ex - scene.hitch * (ca.cos(lh) - ca.cos(rh))
    hy = ey - scene.hitch * (ca.sin(lh) - ca.sin(rh))
    reach = d_max - ca.sqrt(hx**2 + hy**2 + far.EPSILON)
    nlp.subject_to("net_reach", NET_REACH, reach[bounded.tolist()], stages=bounded)
    for h in (lh, rh):
        value = (ey * ca.cos(h) - ex * ca.sin(h)) / d
        nlp.subject_to("abreast", math.cos(p["max_skew"] - SKEW), value[1:-1], stages=inner)


def add_things(nlp, scene, full, rows, elastic):
    """What robots and the line between them keep from objects and obstacles."""
    p, ops = scene.planner, far.Symbols
    (lx, ly, _), (rx, ry, _) = full

    def keep(name, value, bound, stages):
        """value >= bound; with `elastic` the margin gives way at a price, what the claim needs does not."""
        if elastic:
            give = max(p["clearance"] - sag(scene), 0.0)
            e = nlp.variable("e", np.zeros(value.numel()), 0, give, stages)
            nlp.f += ELASTIC_WEIGHT * ca.sum1(e)
            value = value + e
        nlp.subject_to(name, bound, value, stages=stages)

    for robot, (x, y, _) in enumerate(full):
        for k, (px, py, radius) in enumerate(scene.objects):
            at = sorted(i for i, r, o in rows.objects if (r, o) == (robot, k))
            if at:
                keep("object", far.to_point(ops, x[at], y[at], px, py), scene.radius + radius + p["clearance"], at)
        for k, piece in enumerate(scene.pieces):
            at = sorted(i for i, r, o in rows.pieces if (r, o) == (robot, k))
            if at:
                keep("obstacle", far.to_piece(ops, x[at], y[at], piece), scene.radius + p["clearance"], at)
    for k, piece in enumerate(scene.pieces):
        for corner, place in enumerate(piece.vertices):
            at = sorted(i for i, o, c in rows.corners if (o, c) == (k, corner))
            if at:
                gap = far.corner_to_line(ops, lx[at], ly[at], rx[at], ry[at], place)
                keep("net", gap, p["clearance"] + piece.radius, at)
    for i, k in sorted(rows.sides):
        px, py, radius = scene.objects[k]
        ex, ey = lx[i] - rx[i], ly[i] - ry[i]
        for (x, y, _), sign in ((full[0], 1), (full[1], -1)):
            out = sign * ((x[i] - px) * ex + (y[i] - py) * ey) / ca.sqrt(ex**2 + ey**2)
            nlp.subject_to("side", 0.9 * (radius + scene.radius), out, stages=[i])
