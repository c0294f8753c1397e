"""What planning and driving return beside `Plan`: plain data, frozen, with numpy arrays where there are many numbers.

SI units and radians, map frame. Pairs are (left, right), as seen by someone who walks behind the robots. The arrays come from
the library without a copy, are read-only and own their memory.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass, fields, is_dataclass
from html import escape
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Pair = tuple[float, float]
Place = tuple[float, float]

__all__ = [
    "Certificate",
    "Circle",
    "Claim",
    "Cost",
    "Curve",
    "Event",
    "Execution",
    "LeftOut",
    "LengthCurve",
    "LengthPoint",
    "Proof",
    "Rehearsal",
    "Solver",
    "Trial",
    "Verdict",
]


def _plain(value: Any) -> Any:
    """As JSON has it: arrays and tuples as lists, what is infinite as None."""
    if is_dataclass(value):
        return {field.name: _plain(getattr(value, field.name)) for field in fields(value)}
    if isinstance(value, np.ndarray):
        return _plain(value.tolist())
    if isinstance(value, dict):
        return {key: _plain(element) for key, element in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain(element) for element in value]
    if isinstance(value, float) and not np.isfinite(value):
        return None
    return value


class _Data:
    """What all results have."""

    def to_dict(self) -> dict[str, Any]:
        """As plain data: arrays as lists, infinite numbers as None."""
        plain: dict[str, Any] = _plain(self)
        return plain

    def save(self, path: str | PathLike[str]) -> None:
        """Writes it as JSON."""
        _write(path, json.dumps(self.to_dict(), indent=1) + "\n")


def _write(path: str | PathLike[str], text: str) -> None:
    """Writes a file whole or not at all."""
    target = Path(path)
    temporary = target.with_name(f".{target.name}.unfinished")
    temporary.write_text(text, encoding="utf-8")
    temporary.replace(target)


@dataclass(frozen=True)
class Cost(_Data):
    """The paper's J on the two trajectories, each term with its weight."""

    total: float
    """J: the sum of the others."""
    smoothness: float
    """Second differences of x, y and heading of both robots."""
    distance: float
    """Driven distance and turning of both robots."""
    obstacle: float
    """0 on every valid plan."""
    expansion: float
    """How far the net is opened or folded, summed over the waypoints."""


@dataclass(frozen=True)
class Claim(_Data):
    """One claim of a certificate with its tightest place."""

    name: str
    """Which claim, as in the file format."""
    holds: bool
    """True when it holds at every instant."""
    margin: float
    """Room that is left, in `unit`; negative when it fails, infinite when nothing bounds it."""
    unit: str
    """m, rad or m/s; empty when the margin has none."""
    meaning: str
    """What it says."""
    step: int | None
    """The step or waypoint where it is tightest."""
    place: Place | None
    """Where it is tightest, m."""
    detail: str
    """What it is about there."""


@dataclass(frozen=True)
class Certificate(_Data):
    """A proof, claim by claim: `certificate["separation"].margin`."""

    claims: tuple[Claim, ...]
    """In the order of the file format."""

    @property
    def valid(self) -> bool:
        """True when there are claims and all hold."""
        return bool(self.claims) and all(claim.holds for claim in self.claims)

    @property
    def failed(self) -> tuple[Claim, ...]:
        """The claims that fail."""
        return tuple(claim for claim in self.claims if not claim.holds)

    def __getitem__(self, name: str) -> Claim:
        for claim in self.claims:
            if claim.name == name:
                return claim
        raise KeyError(name)

    def __iter__(self) -> Iterator[Claim]:
        return iter(self.claims)

    def __len__(self) -> int:
        return len(self.claims)

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><td>{claim.name}</td><td>{'holds' if claim.holds else '<b>fails</b>'}</td>"
            f"<td>{claim.margin:.4g} {claim.unit}</td><td>{escape(claim.detail)}</td></tr>"
            for claim in self.claims
        )
        return f"<table><tr><th>claim</th><th></th><th>margin</th><th></th></tr>{rows}</table>"


@dataclass(frozen=True)
class Circle(_Data):
    """A circle around one object or several close ones."""

    center: Place
    """m."""
    radius: float
    """m."""
    objects: tuple[int, ...]
    """Indices of the scene's objects inside."""


@dataclass(frozen=True)
class LeftOut(_Data):
    """An object that a plan leaves where it is."""

    object: int
    """Its index in the scene."""
    why: str
    """`proven`: there is a proof that no plan sweeps it; `not_found`: the search did not succeed with it."""
    text: str
    """The reason in full."""


@dataclass(frozen=True)
class Solver(_Data):
    """How the optimization ended."""

    status: str
    """Such as `converged`."""
    iterations: int
    """Of the last optimization."""
    kkt_error: float
    """Scaled error of the optimality conditions."""
    seconds: float
    """Time spent on it: the only number in a plan that differs between runs."""


@dataclass(frozen=True)
class Verdict(_Data):
    """What a rehearsal said. Never a proof."""

    status: str
    """`passed`, `failed` or `skipped`."""
    event: str | None
    """What went wrong first."""
    time: float | None
    """When, s."""
    place: Place | None
    """Where, m."""


@dataclass(frozen=True)
class Proof(_Data):
    """A proof that there is no plan, or none that gathers an object."""

    kind: str
    """The argument, as in the file format."""
    object: int | None
    """The object that it is about; None when it is not about one."""
    text: str
    """The proof in words."""
    move_to: Place | None
    """The nearest place, m, at which it would say nothing against the object any more."""
    move_distance: float | None
    """How far that is, m."""


@dataclass(frozen=True, eq=False)
class Curve(_Data):
    """A quantity over time: one or several lines on one axis."""

    key: str
    """Such as `separation` or `clearance`."""
    title: str
    """For people."""
    unit: str
    """Of all values; empty when they have none."""
    times: Floats
    """Instants, T, s."""
    lines: dict[str, Floats]
    """Values, T each, by their label."""
    roles: dict[str, str]
    """Whose each line is: `left`, `right`, `net` or `other`."""
    limits: dict[str, float]
    """Bounds, by their label."""


@dataclass(frozen=True)
class Event(_Data):
    """Something that should not have happened."""

    time: float
    """When, s."""
    place: Place
    """Where, m."""
    text: str
    """What."""


@dataclass(frozen=True, eq=False)
class Rehearsal(_Data):
    """What happened when a plan was driven closely in physics: T instants, K objects, P points of the net."""

    verdict: Verdict
    events: tuple[Event, ...]
    """In order of time."""
    gathered: tuple[bool, ...]
    """For each object: true when it lies in the net at the end."""
    left_out: tuple[int, ...]
    """Objects that were to stay where they are."""
    max_tension: Pair
    """Greatest tension at the hitches, mean over 20 ms, N."""
    max_deviation: Pair
    """Greatest distance of the robots from their places in the plan, m."""
    mean_drive_force: Pair
    """Mean force along the heading, N."""
    duration: float
    """Simulated time, s."""
    warnings: tuple[str, ...]
    times: Floats
    """T, s."""
    left: Floats
    """Poses of the left robot, T x 3."""
    right: Floats
    """Poses of the right robot, T x 3."""
    net: Floats
    """The net from the left hitch to the right one, T x P x 2, m."""
    objects: Floats
    """Center and turn of each object, T x K x 3."""
    tension: Floats
    """At the hitches, T x 2, N."""
    drive_force: Floats
    """Along the headings, T x 2, N."""

    @property
    def passed(self) -> bool:
        """True when everything was gathered and nothing else was touched."""
        return self.verdict.status == "passed"


@dataclass(frozen=True, eq=False)
class Trial(_Data):
    """One drive by controllers: T instants of what was seen, S samples of what the controllers did."""

    index: int
    seed: int
    conditions: dict[str, Any]
    """What was drawn for it: factors of mass, inertia and friction, masses of objects (kg), delays (s)."""
    gathered: tuple[bool, ...]
    """For each object: true when it lies in the net at the end."""
    left_out: tuple[int, ...]
    """Objects that were to stay where they are."""
    gathered_everything: bool
    """True when the pair came to the end of its way with every object in the net."""
    events: tuple[Event, ...]
    """In order of time."""
    tracking_rms: Pair
    """Root mean square distance from the reference, m."""
    tracking_max: Pair
    """Greatest distance from the reference, m."""
    settled_rms: Pair
    """The same after the first second, m."""
    settled_max: Pair
    """The same after the first second, m."""
    cost: Cost
    """J on the driven path."""
    mean_drag: Pair
    """Mean force of net and contacts, N."""
    max_drag: Pair
    """Greatest force of net and contacts, mean over 20 ms, N."""
    max_torque: Pair
    """Greatest torque of a wheel, N m."""
    duration: float
    """Simulated time, s."""
    seconds: float
    """Time it took to compute, s: the only number that differs between runs."""
    times: Floats
    """T, s."""
    left: Floats
    """Poses of the left robot, T x 3."""
    right: Floats
    """Poses of the right robot, T x 3."""
    net: Floats
    """The net from the left hitch to the right one, T x P x 2, m."""
    objects: Floats
    """Center and turn of each object, T x K x 3."""
    tension: Floats
    """At the hitches, T x 2, N."""
    drive_force: Floats
    """Along the headings, T x 2, N."""
    sample_times: Floats
    """S, s."""
    error: Floats
    """Distance from the reference, S x 2, m."""
    forward: Floats
    """Speeds, S x 2, m/s."""
    turn_rate: Floats
    """Turning rates, S x 2, rad/s."""
    drag: Floats
    """Force of net and contacts, S x 2, N."""
    torque: Floats
    """Of the left and the right wheel of each robot, S x 2 x 2, N m."""


@dataclass(frozen=True, eq=False)
class Execution(_Data):
    """Drives of one plan by controllers."""

    controller: str
    net_length: float
    """m."""
    reference_duration: float
    """Time from start to end of the smooth curve that is followed, s."""
    trials_wanted: int
    interrupted: bool
    """True when it was stopped before all drives were finished."""
    gathered_everything: bool
    """True when every wanted drive gathered everything."""
    trials: tuple[Trial, ...]
    """The finished drives."""
    warnings: tuple[str, ...]
    json: str
    """The text of the file, format pairtrawl-execution/1."""

    def to_dict(self) -> dict[str, Any]:
        """The execution file as a dictionary."""
        data: dict[str, Any] = json.loads(self.json)
        return data

    def save(self, path: str | PathLike[str]) -> None:
        """Writes execution.json. `run(..., output=FOLDER)` writes report and recording as well."""
        _write(path, self.json)


@dataclass(frozen=True)
class LengthPoint(_Data):
    """One length of the net."""

    net_length: float
    """m."""
    cost: Cost | None
    """J of the certified plan; None where there is none."""
    error: str | None
    """Why there is none."""
    proven: bool
    """True where it is proven that there is none."""


@dataclass(frozen=True)
class LengthCurve(_Data):
    """The cost of the best plan over the length of the net, route and sides fixed."""

    scene: str
    points: tuple[LengthPoint, ...]
    """By increasing length."""
    best_length: float | None
    """The best length found, m."""
    best_cost: Cost | None
    """Its cost."""
    flat_range: Pair | None
    """Lengths around the best one at which J is at most 1 % more, m."""
    svg: str
    """The curve as a picture."""

    @property
    def net_lengths(self) -> Floats:
        """The lengths, N, m."""
        return np.array([point.net_length for point in self.points])

    @property
    def totals(self) -> Floats:
        """J at each length, N; NaN where there is no plan."""
        return np.array([point.cost.total if point.cost else np.nan for point in self.points])

    def to_dict(self) -> dict[str, Any]:
        """As plain data, without the picture."""
        data = super().to_dict()
        del data["svg"]
        return data

    def _repr_html_(self) -> str:
        return self.svg
