"""Arrays: read-only, made once, alive as long as somebody looks at them."""

from __future__ import annotations

import gc

import numpy as np
import pytest

import pairtrawl as pt


def test_arrays_are_made_once_and_slices_are_views(hall_plan: pt.Plan) -> None:
    assert hall_plan.left is hall_plan.left
    positions = hall_plan.left[:, :2]
    assert positions.base is not None and np.shares_memory(positions, hall_plan.left)
    assert hall_plan.left.dtype == np.float64 and hall_plan.left.flags.c_contiguous


def test_nobody_writes_to_them(hall_plan: pt.Plan) -> None:
    with pytest.raises(ValueError, match="read-only"):
        hall_plan.left[0, 0] = 1.0
    with pytest.raises(ValueError):
        hall_plan.left.setflags(write=True)


def test_a_view_outlives_its_plan() -> None:
    def views() -> list[np.ndarray]:
        scene = pt.generate(difficulty=1, waypoints=80)
        plan = pt.plan(scene, rehearsal="skip", explore=False)
        return [plan.left[:, :2], plan.times[::2], plan.centerline[1:], scene.objects[:1]]

    kept = views()
    copies = [np.array(view) for view in kept]
    for _ in range(20):
        views()
        gc.collect()
    assert all(np.array_equal(view, copy) for view, copy in zip(kept, copies))
