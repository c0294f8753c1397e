"""Pictures by matplotlib: the map with a plan, what changes over time, J over the net length, quantiles of a sweep.

Every function draws into `ax`, or into a new figure, and returns the axes. The numbers are those of the library's reports. Colors
are those of Okabe and Ito, which people tell apart whatever their color vision, and no meaning is in a color alone.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.patches import Circle as Disc
from matplotlib.patches import PathPatch, Polygon, Rectangle
from matplotlib.path import Path as Outline

from pairtrawl._native import Plan, Scene
from pairtrawl.errors import InputError, NoPlanError
from pairtrawl.results import Curve, LengthCurve, Rehearsal, Trial

if TYPE_CHECKING:
    import pandas as pd

__all__ = ["clearance", "curve", "failure", "length", "map", "quantiles", "separation"]

LEFT = "#0072B2"
"""The left robot: blue, drawn through."""
RIGHT = "#D55E00"
"""The right robot: vermilion, dashed."""
NET = "#009E73"
"""The net: bluish green."""
OTHER = "#000000"
OBSTACLE = "#999999"
OBJECT = "#E69F00"
"""Objects: orange discs with their numbers."""
WRONG = "#CC79A7"
"""What fails: reddish purple, with a cross."""

_STYLES = {"left": (LEFT, "-"), "right": (RIGHT, "--"), "net": (NET, "-."), "other": (OTHER, "-")}


def map(
    scene: Scene,
    plan: Plan | None = None,
    *,
    drive: Rehearsal | Trial | None = None,
    lines: int = 40,
    ax: Axes | None = None,
) -> Axes:
    """The map: obstacles, numbered objects, start and end; with a plan both paths and the line between the robots.

    drive: a rehearsal or a trial; its paths and the net at its end are drawn as well. lines: how many positions of the line
    between the robots are shown.
    """
    ax = _axes(ax, (8.0, 6.0))
    _floor(ax, scene)
    _objects(ax, scene, plan)
    for number, (pair, mark) in enumerate(((scene.start, "o"), (scene.end, "s"))):
        ends = "start" if number == 0 else "end"
        ax.plot(pair[:, 0], pair[:, 1], mark, color=OTHER, mfc="white", ms=7, label=ends, zorder=6)
    title = scene.name
    if plan is not None:
        shown = np.linspace(0, len(plan) - 1, min(lines, len(plan))).astype(int)
        across = np.stack([plan.left[shown, :2], plan.right[shown, :2]], axis=1)
        ax.add_collection(LineCollection(list(across), colors=NET, lw=0.6, alpha=0.6, label="line between the robots"))
        _path(ax, plan.left, "left", "left robot")
        _path(ax, plan.right, "right", "right robot")
        title += f": net {plan.net_length:.3f} m, J {plan.cost.total:.1f}"
    if drive is not None:
        for poses in (drive.left, drive.right):
            ax.plot(poses[:, 0], poses[:, 1], color=OTHER, lw=0.6, ls=":", zorder=5)
        ax.plot(drive.net[-1, :, 0], drive.net[-1, :, 1], color=NET, lw=2.0, label="net at the end", zorder=6)
        ax.plot(drive.objects[-1, :, 0], drive.objects[-1, :, 1], "x", color=OTHER, ms=5, label="objects at the end", zorder=7)
    (x0, y0), (x1, y1) = scene.bounds
    ax.set(xlim=(x0 - 0.1, x1 + 0.1), ylim=(y0 - 0.1, y1 + 0.1), xlabel="x (m)", ylabel="y (m)", title=title)
    ax.set_aspect("equal")
    ax.legend(loc="center left", bbox_to_anchor=(1.01, 0.5), fontsize="small", frameon=False)
    return ax


def _floor(ax: Axes, scene: Scene) -> None:
    (x0, y0), (x1, y1) = scene.bounds
    rings = scene.free_rings
    if rings is None:
        ax.add_patch(Rectangle((x0, y0), x1 - x0, y1 - y0, fc="none", ec=OTHER, lw=0.8))
    else:
        ax.add_patch(Rectangle((x0, y0), x1 - x0, y1 - y0, fc=OBSTACLE, ec="none"))
        # Rings in rings are holes.
        closed = [np.vstack([ring, ring[:1]]) for ring in rings]
        codes = [[Outline.MOVETO] + [Outline.LINETO] * (len(ring) - 2) + [Outline.CLOSEPOLY] for ring in closed]
        floor = Outline(np.vstack(closed), np.concatenate(codes).astype(np.uint8))
        ax.add_patch(PathPatch(floor, fc="white", ec="none"))
    style: dict[str, Any] = {"fc": OBSTACLE, "ec": "#555555", "hatch": "///", "lw": 0.5, "zorder": 2}
    for obstacle in scene.obstacles:
        if "box" in obstacle:
            a, b, c, d = obstacle["box"]
            ax.add_patch(Rectangle((a, b), c - a, d - b, **style))
        elif "polygon" in obstacle:
            ax.add_patch(Polygon(obstacle["polygon"], closed=True, **style))
        else:
            x, y, radius = obstacle["circle"]
            ax.add_patch(Disc((x, y), radius, **style))


def _objects(ax: Axes, scene: Scene, plan: Plan | None) -> None:
    left = set() if plan is None else {one.object for one in plan.left_out}
    for index, ((x, y), radius) in enumerate(zip(scene.objects, scene.object_radii)):
        ax.add_patch(Disc((x, y), radius, fc="white" if index in left else OBJECT, ec=OTHER, lw=0.6, zorder=4))
        text = f"{index} (stays)" if index in left else str(index)
        ax.annotate(text, (x, y), xytext=(4, 4), textcoords="offset points", fontsize="x-small", zorder=7)


def _path(ax: Axes, poses: np.ndarray[Any, Any], role: str, label: str) -> None:
    color, style = _STYLES[role]
    ax.plot(poses[:, 0], poses[:, 1], color=color, ls=style, lw=1.6, label=label, zorder=5)


def curve(shown: Curve, *, ax: Axes | None = None) -> Axes:
    """A quantity over time with its bounds: one of `plan.curves()`."""
    ax = _axes(ax, (8.0, 3.0))
    for label, values in shown.lines.items():
        color, style = _STYLES[shown.roles[label]]
        ax.plot(shown.times, values, color=color, ls=style, lw=1.3, label=label)
    for label, value in shown.limits.items():
        ax.axhline(value, color=WRONG, lw=0.9, ls=":")
        ax.annotate(label, (1.0, value), xycoords=("axes fraction", "data"), ha="right", va="bottom", fontsize="x-small")
    unit = f" ({shown.unit})" if shown.unit else ""
    ax.set(xlabel="time (s)", ylabel=f"{shown.title}{unit}", title=shown.title)
    ax.legend(fontsize="small", frameon=False)
    return ax


def _of_plan(plan: Plan, key: str, ax: Axes | None) -> Axes:
    for one in plan.curves():
        if one.key == key:
            return curve(one, ax=ax)
    raise InputError(f"the plan has no curve {key}: there is nothing in its scene that bounds it")


def separation(plan: Plan, *, ax: Axes | None = None) -> Axes:
    """Distances between the robots and between the hitches over time, with the bounds of the net."""
    return _of_plan(plan, "separation", ax)


def clearance(plan: Plan, *, ax: Axes | None = None) -> Axes:
    """What robots and net keep from the obstacles over time."""
    return _of_plan(plan, "clearance", ax)


def length(study: LengthCurve, *, ax: Axes | None = None) -> Axes:
    """J over the length of the net, the best length, and the range in which J is at most 1 % more."""
    ax = _axes(ax, (7.0, 4.0))
    ax.plot(study.net_lengths, study.totals, "o-", color=LEFT, ms=4, label="J of the best plan")
    refused = [point.net_length for point in study.points if point.cost is None]
    if refused:
        low = np.nanmin(study.totals) if np.isfinite(study.totals).any() else 0.0
        ax.plot(refused, [low] * len(refused), "x", color=WRONG, label="no plan")
    if study.best_length is not None and study.best_cost is not None:
        ax.plot(study.best_length, study.best_cost.total, "*", color=RIGHT, ms=12, label=f"best: {study.best_length:.3f} m")
    if study.flat_range is not None:
        ax.axvspan(*study.flat_range, color=NET, alpha=0.15, label="at most 1 % more")
    ax.set(xlabel="length of the net (m)", ylabel="J", title=f"{study.scene}: cost over the length of the net")
    ax.legend(fontsize="small", frameon=False)
    return ax


def quantiles(
    table: pd.DataFrame,
    x: str = "net_length",
    y: str = "total",
    *,
    levels: Sequence[float] = (0.1, 0.25, 0.5, 0.75, 0.9),
    relative: bool = False,
    ax: Axes | None = None,
) -> Axes:
    """Quantiles of a column of a sweep over another, with the share of scenes that have a plan.

    relative: each scene's values over its least, so that scenes of different sizes can be compared.
    """
    ax = _axes(ax, (7.0, 4.0))
    values = table[y].astype(float)
    if relative:
        values = values / values.groupby(table["scene_sha256"]).transform("min")
    groups = values.groupby(table[x])
    cuts = groups.quantile(np.array(levels)).unstack()
    xs = cuts.index.to_numpy(dtype=float)
    for low, high in zip(levels, reversed(levels)):
        if low < high:
            ax.fill_between(xs, cuts[low], cuts[high], color=LEFT, alpha=0.2, lw=0, label=f"{low:.0%} to {high:.0%}")
    if 0.5 in levels:
        ax.plot(xs, cuts[0.5], "o-", color=LEFT, ms=3, label="median")
    share = groups.count() / groups.size()
    other = ax.twinx()
    other.plot(xs, share, "s:", color=RIGHT, ms=3, label="share with a plan")
    other.set(ylim=(0.0, 1.05), ylabel="share with a plan")
    name = f"{y} over the scene's least" if relative else y
    ax.set(xlabel=x.replace("_", " "), ylabel=name, title=f"{table['scene_sha256'].nunique()} scenes")
    handles = [*ax.get_legend_handles_labels()[0], *other.get_legend_handles_labels()[0]]
    ax.legend(handles, [str(handle.get_label()) for handle in handles], fontsize="small", frameon=False)
    return ax


def failure(error: NoPlanError, scene: Scene, *, ax: Axes | None = None) -> Axes:
    """The best attempt of a search that found no plan, with the place where a claim fails. It shows no plan."""
    ax = map(scene, error.best, ax=ax)
    if error.place is not None:
        what = error.claim.name if error.claim is not None else "fails here"
        ax.plot(*error.place, "x", color=WRONG, ms=14, mew=3, zorder=9)
        ax.annotate(what, error.place, xytext=(10, 10), textcoords="offset points", color=OTHER, zorder=9)
    ax.set_title(f"{scene.name}: no plan was found")
    return ax


def _axes(ax: Axes | None, size: tuple[float, float]) -> Axes:
    if ax is not None:
        return ax
    _, new = plt.subplots(figsize=size, layout="constrained")
    return new
