"""What tests share: the paper's scene, a small hall, and plans of them."""

from __future__ import annotations

from pathlib import Path

import pytest

import pairtrawl as pt

ROOT = Path(__file__).parents[2]

HALL = {
    "name": "small hall",
    "area": {"min": [0.0, 0.0], "max": [4.0, 3.0]},
    "objects": [{"position": [2.0, 1.5], "radius": 0.03}],
    "start": {"left": [0.5, 1.85], "right": [0.5, 1.15], "heading": 0.0},
    "end": {"left": [3.5, 1.85], "right": [3.5, 1.15], "heading": 0.0},
}


@pytest.fixture
def hall() -> pt.Scene:
    """A hall of 4 x 3 m with one object: planned in milliseconds."""
    return pt.Scene.from_dict(HALL)


@pytest.fixture(scope="session")
def paper() -> pt.Scene:
    """The paper's experiment."""
    return pt.Scene.from_file(ROOT / "scenes/paper-experiment/scene.toml")


@pytest.fixture(scope="session")
def paper_plan(paper: pt.Scene) -> pt.Plan:
    """A plan of it, rehearsed."""
    return pt.plan(paper)


@pytest.fixture
def hall_plan(hall: pt.Scene) -> pt.Plan:
    """A plan of the small hall, not rehearsed."""
    return pt.plan(hall, rehearsal="skip")
