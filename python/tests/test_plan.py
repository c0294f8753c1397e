"""Plans: what they hold, how they are written, compared and taken apart."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import pairtrawl as pt
from pairtrawl.sweeping.rows import CLAIMS


def test_a_plan_is_proven_and_can_be_looked_at(paper: pt.Scene, paper_plan: pt.Plan) -> None:
    plan = paper_plan
    count = len(plan)
    assert plan.left.shape == plan.right.shape == (count, 3)
    assert plan.times.shape == (count,)
    assert np.all(np.diff(plan.times) > 0)
    assert plan.duration == plan.times[-1]
    assert np.allclose(plan.left[0], paper.start[0], atol=1e-6)
    assert np.allclose(plan.right[-1][:2], paper.end[1][:2], atol=1e-6)
    terms = plan.cost.smoothness + plan.cost.distance + plan.cost.obstacle + plan.cost.expansion
    assert plan.cost.total == pytest.approx(terms)
    assert plan.certificate.valid and not plan.certificate.failed
    assert {claim.name for claim in plan.certificate} <= set(CLAIMS)
    assert plan.certificate["separation"].margin >= -1e-9
    with pytest.raises(KeyError):
        plan.certificate["luck"]
    assert sorted(i for circle in plan.circles for i in circle.objects) == list(range(len(paper.objects)))
    assert sorted(plan.order) == list(range(len(plan.circles)))
    assert plan.rehearsal.status == "passed"
    assert plan.solver.status == "converged"
    assert plan.stages["optimize"] > 0
    assert plan.scene == paper
    assert all(time is not None and 0 < time < plan.duration for time in plan.swept_at())
    assert plan.waypoint_at(plan.duration) == count - 1


def test_check_agrees_and_notices_a_changed_scene(paper: pt.Scene, paper_plan: pt.Plan) -> None:
    assert pt.check(paper, paper_plan) == paper_plan.certificate
    changed = paper.copy()
    x, y = paper_plan.left[len(paper_plan) // 2, :2]
    changed.add_obstacle(circle=(x, y, 0.05))
    refused = pt.check(changed, paper_plan)
    assert not refused.valid
    failed = {claim.name for claim in refused.failed}
    assert {"scene", "robot_clearance"} <= failed


def test_options(hall: pt.Scene) -> None:
    plan = pt.plan(hall, net_length=1.2, waypoints=90, rehearsal=False, explore=False, leave="unreachable", seed=4)
    assert (plan.net_length, len(plan), plan.rehearsal.status) == (1.2, 90, "skipped")
    assert pt.plan(hall, net_length="auto", rehearsal="skip").net_length > 0.7
    for bad in (
        {"net_length": -1.0},
        {"net_length": "long"},
        {"waypoints": 2},
        {"order": "random"},
        {"method": "magic"},
        {"time_limit": 0.0},
        {"rehearsal": "maybe"},
        {"leave": "all"},
        {"seed": -1},
        {"tolerance": 0.1},
    ):
        (name,) = bad
        with pytest.raises(pt.InputError, match=name):
            pt.plan(hall, **bad)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="did you mean net_length"):
        pt.plan(hall, net_lenght=1.2)  # type: ignore[call-arg]


def test_files(paper: pt.Scene, paper_plan: pt.Plan, tmp_path: Path) -> None:
    paper_plan.save(tmp_path / "all")
    names = {"plan.json", "plan.csv", "left.tum", "right.tum", "plan.svg", "report.html"}
    assert {path.name for path in (tmp_path / "all").iterdir()} == names
    for name in ("one.json", "one.csv", "one.svg", "one.html"):
        paper_plan.save(tmp_path / name)
        assert (tmp_path / name).stat().st_size > 0
    with pytest.raises(pt.InputError, match=r"\.docx"):
        paper_plan.save(tmp_path / "one.docx")
    assert paper_plan.to_dict() == json.loads((tmp_path / "one.json").read_text())
    again = pt.Plan.from_file(tmp_path / "one.json", paper)
    assert again.certificate == paper_plan.certificate
    assert np.array_equal(again.left, paper_plan.left)


def test_the_same_bits_on_any_number_of_threads(paper: pt.Scene, paper_plan: pt.Plan) -> None:
    again = pt.plan(paper, threads=1)
    assert again == paper_plan
    assert again.digest == paper_plan.digest
    other = pt.plan(paper, net_length=1.6)
    assert other != paper_plan
    assert other.digest != paper_plan.digest


def test_curves_are_those_of_the_report(paper_plan: pt.Plan) -> None:
    curves = {curve.key: curve for curve in paper_plan.curves()}
    separation = curves["separation"].lines["robots"]
    assert np.allclose(separation, np.linalg.norm(paper_plan.left[:, :2] - paper_plan.right[:, :2], axis=1))
    for curve in curves.values():
        assert all(line.shape == curve.times.shape for line in curve.lines.values())
    assert curves["clearance"].unit == "m"


def test_replan_from_the_way(paper: pt.Scene, paper_plan: pt.Plan) -> None:
    passed = paper_plan.waypoint_at(10.0)
    scene = paper.copy()
    gathered = [i for i, time in enumerate(paper_plan.swept_at()) if time is not None and time <= 11.0]
    for index in reversed(gathered):
        scene.remove_object(index)
    left, right = paper_plan.left[passed], paper_plan.right[passed]
    scene.set_start(left[:2], right[:2], left_heading=left[2], right_heading=right[2])
    rest = pt.replan(paper_plan, scene, passed=passed, rehearsal="skip")
    assert rest.certificate.valid
    assert rest.net_length == paper_plan.net_length
    assert len(rest) < len(paper_plan)


def test_length_curve(hall: pt.Scene) -> None:
    curve = pt.length_curve(hall, start=0.5, stop=2.0, points=4)
    assert np.allclose(curve.net_lengths, [0.5, 1.0, 1.5, 2.0])
    assert curve.points[0].proven and curve.points[0].error is not None
    assert np.isnan(curve.totals[0]) and np.all(curve.totals[1:] > 0)
    assert curve.best_cost is not None and curve.best_cost.total <= np.nanmin(curve.totals) + 1e-9
    assert "svg" in curve._repr_html_()
    assert json.loads(json.dumps(curve.to_dict()))["points"][1]["cost"]["total"] > 0
    with pytest.raises(pt.InputError, match="lengths from 2"):
        pt.length_curve(hall, start=2.0, stop=1.0)


def test_pictures(paper_plan: pt.Plan) -> None:
    assert paper_plan._repr_html_().startswith("<svg")
    assert "holds" in paper_plan.certificate._repr_html_()
    assert repr(paper_plan).startswith('<Plan of "paper-experiment"')
