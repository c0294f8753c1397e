"""Plan, prove, rehearse and execute runs of two robots that tow a net.

    import pairtrawl as pt

    scene = pt.Scene.from_file("scenes/paper-experiment/scene.toml")
    plan = pt.plan(scene)
    pt.check(scene, plan).valid

SI units and radians; map frame of REP-103. `left` and `right` are as seen by someone who walks behind the pair.
`docs/python.md` is the guide.
"""

from __future__ import annotations

import importlib
from types import ModuleType
from typing import TYPE_CHECKING

from pairtrawl._native import Plan, Scene
from pairtrawl.errors import (
    FileAccessError,
    InfeasibleError,
    InputError,
    InternalError,
    NoPlanError,
    PairtrawlError,
    PlanningError,
    TimeLimitError,
)
from pairtrawl.planning import (
    check,
    generate,
    length_curve,
    plan,
    plan_batch,
    rehearse,
    replan,
    run,
)
from pairtrawl.progress import ProgressEvent
from pairtrawl.sweeping import sweep

if TYPE_CHECKING:
    from pairtrawl import plot

__all__ = [
    "FileAccessError",
    "InfeasibleError",
    "InputError",
    "InternalError",
    "NoPlanError",
    "PairtrawlError",
    "Plan",
    "PlanningError",
    "ProgressEvent",
    "Scene",
    "TimeLimitError",
    "check",
    "generate",
    "length_curve",
    "plan",
    "plan_batch",
    "plot",
    "rehearse",
    "replan",
    "run",
    "sweep",
]


def __getattr__(name: str) -> ModuleType:
    # matplotlib is loaded by whoever draws.
    if name == "plot":
        return importlib.import_module("pairtrawl.plot")
    raise AttributeError(f"module 'pairtrawl' has no attribute {name!r}")
