"""Distances of points and of the line between the robots to convex pieces, for numpy arrays and CasADi columns alike."""

import casadi as ca
import numpy as np

# Keeps the derivative of a square root finite at zero; changes a distance of 0.29 m by less than 1e-11 m.
EPSILON = 1e-12


class Numbers:
    """The operations on numpy arrays."""

    sqrt, fmin, fmax = np.sqrt, np.minimum, np.maximum

    @staticmethod
    def choose(condition, yes, no):
        return np.where(condition, yes, no)


class Symbols:
    """The operations on CasADi columns."""

    sqrt, fmin, fmax = ca.sqrt, ca.fmin, ca.fmax

    @staticmethod
    def choose(condition, yes, no):
        return ca.if_else(condition, yes, no)


def to_point(ops, x, y, px, py):
    """Distance to a point (a number or a column)."""
    return ops.sqrt((x - px) ** 2 + (y - py) ** 2 + EPSILON)


def to_piece(ops, x, y, piece):
    """Signed distance to a convex piece, exact; continuously differentiable outside."""
    v = piece.vertices
    if len(v) == 1:
        return to_point(ops, x, y, v[0, 0], v[0, 1]) - piece.radius
    squared = foremost = None
    for a, b in zip(v, np.roll(v, -1, 0)):
        e = b - a
        length = np.hypot(*e)
        t, n = e / length, np.array([e[1], -e[0]]) / length
        out = n[0] * (x - a[0]) + n[1] * (y - a[1])
        along = t[0] * (x - a[0]) + t[1] * (y - a[1])
        beyond = ops.fmax(ops.fmax(-along, along - length), 0.0)
        here = out**2 + beyond**2
        squared = here if squared is None else ops.fmin(squared, here)
        foremost = out if foremost is None else ops.fmax(foremost, out)
    return ops.choose(foremost > 0, ops.sqrt(squared + EPSILON), foremost)


def corner_to_line(ops, lx, ly, rx, ry, corner):
    """Distance of a corner to the segment between the robots. Their ends keep the radius from the piece anyway."""
    ex, ey, qx, qy = lx - rx, ly - ry, corner[0] - rx, corner[1] - ry
    t = ops.fmin(ops.fmax((qx * ex + qy * ey) / (ex**2 + ey**2), 0.0), 1.0)
    return ops.sqrt((qx - t * ex) ** 2 + (qy - t * ey) ** 2 + EPSILON)
