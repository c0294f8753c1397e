"""What the comparison reads of a scene: FORMATS of the repository, boxes, circles and convex polygons only."""

import math
import tomllib
from dataclasses import dataclass

import numpy as np

PLANNER = {
    "max_step": 0.05, "max_turn": 0.1, "max_skew": 1.0, "clearance": 0.05, "min_ratio": 0.1, "rest_ratio": 2 / math.pi,
    "t1": 300.0, "t2": 10.0, "kd1": 20.0, "kd2": 15.0, "b1": 110.0, "b2": 110.0, "b3": 1.0,
    "a1": 1.0, "a2": 1.0, "a4": 1.0,
}  # fmt: skip


@dataclass
class Piece:
    """A convex obstacle: counter-clockwise vertices (one for a disc) grown by `radius`."""

    vertices: np.ndarray
    radius: float


@dataclass
class Scene:
    """Poses are (x, y, heading), left robot first; objects are (x, y, footprint radius)."""

    start: np.ndarray
    end: np.ndarray
    area: tuple
    pieces: list
    objects: np.ndarray
    radius: float
    hitch: float
    planner: dict


def read_scene(path):
    """A scene, or ValueError for what this comparison cannot model."""
    with open(path, "rb") as file:
        data = tomllib.load(file)
    if "map" in data["area"]:
        raise ValueError(f"{path}: ROS maps are not part of this comparison")
    planner = dict(PLANNER)
    for key, value in data.get("planner", {}).items():
        if key in planner:
            planner[key] = value
    robot = data.get("robot", {})
    return Scene(
        start=_poses(data["start"]),
        end=_poses(data["end"]),
        area=(data["area"]["min"], data["area"]["max"]),
        pieces=[_piece(o, path) for o in data.get("obstacles", [])],
        objects=np.array([_object(o) for o in data.get("objects", [])]).reshape(-1, 3),
        radius=robot.get("radius", 0.24),
        hitch=robot.get("hitch", 0.207),
        planner=planner,
    )


def _poses(ends):
    heading = ends.get("heading")
    return np.array([[*ends[s], ends.get(f"{s}_heading", heading)] for s in ("left", "right")], float)


def _object(item):
    radius = item["radius"] if "radius" in item else 0.5 * math.hypot(*item["size"])
    return [*item["position"], radius]


def _piece(item, path):
    if "box" in item:
        x0, y0, x1, y1 = item["box"]
        return Piece(np.array([[x0, y0], [x1, y0], [x1, y1], [x0, y1]]), 0.0)
    if "circle" in item:
        x, y, radius = item["circle"]
        return Piece(np.array([[x, y]]), radius)
    vertices = np.array(item["polygon"], float)
    edges = np.roll(vertices, -1, 0) - vertices
    turns = edges[:, 0] * np.roll(edges, -1, 0)[:, 1] - edges[:, 1] * np.roll(edges, -1, 0)[:, 0]
    if (turns < 0).all():
        return Piece(vertices[::-1].copy(), 0.0)
    if not (turns >= 0).all():
        raise ValueError(f"{path}: a polygon that is not convex is not part of this comparison")
    return Piece(vertices, 0.0)


def cost(planner, left, right, net_length):
    """The paper's J without J_obs (zero on every valid plan), with the + sign in J_e: (total, smoothness, distance, J_e)."""
    p = planner
    smoothness = distance = 0.0
    for robot in (np.asarray(left), np.asarray(right)):
        step = np.diff(robot, axis=0)
        distance += p["a2"] * (p["t1"] * np.hypot(step[:, 0], step[:, 1]).sum() + p["t2"] * np.abs(step[:, 2]).sum())
        bend = np.diff(robot, 2, axis=0)
        smoothness += p["a1"] * (bend**2 @ np.array([p["b1"], p["b2"], p["b3"]])).sum()
    d = np.hypot(*(np.asarray(left)[:, :2] - np.asarray(right)[:, :2]).T)
    least, rest = p["min_ratio"] * net_length, p["rest_ratio"] * net_length
    if (d < least).any() or (d > net_length).any():
        return math.inf, smoothness, distance, math.inf
    inner = p["kd1"] * np.tan(0.5 * math.pi * (d - rest) / (rest - least)) ** 2
    with np.errstate(divide="ignore"):
        outer = p["kd2"] * (d - rest) ** 2 + (d - rest) ** 2 / (d - net_length) ** 2
    expansion = p["a4"] * np.where(d <= rest, inner, outer).sum()
    return smoothness + distance + expansion, smoothness, distance, expansion
