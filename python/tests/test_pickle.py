"""Everything pickles, with all bits."""

from __future__ import annotations

import pickle

import numpy as np

import pairtrawl as pt


def test_scenes(paper: pt.Scene, hall: pt.Scene) -> None:
    hall.set_net(length=1.25)
    for scene in (paper, hall):
        again = pickle.loads(pickle.dumps(scene))
        assert again == scene
        assert again.sha256 == scene.sha256


def test_a_map_goes_along() -> None:
    from conftest import ROOT

    scene = pt.Scene.from_file(ROOT / "scenes/nav2-sandbox/scene.toml")
    again = pickle.loads(pickle.dumps(scene))
    assert again == scene
    assert again.sha256 == scene.sha256


def test_plans(paper: pt.Scene, paper_plan: pt.Plan) -> None:
    again = pickle.loads(pickle.dumps(paper_plan))
    assert again == paper_plan
    assert again.digest == paper_plan.digest
    assert again.certificate == paper_plan.certificate
    assert again.solver == paper_plan.solver
    assert again.stages == paper_plan.stages
    assert again.scene == paper
    assert again.svg() == paper_plan.svg()
    assert pt.check(paper, again).valid
    record, before = again.rehearsal_record, paper_plan.rehearsal_record
    assert record is not None and before is not None
    assert record.to_dict() == before.to_dict()


def test_plans_with_warnings_and_infinite_margins(hall_plan: pt.Plan) -> None:
    assert np.isinf(hall_plan.certificate["robot_clearance"].margin)
    again = pickle.loads(pickle.dumps(hall_plan))
    assert again.certificate == hall_plan.certificate
    assert again.warnings == hall_plan.warnings


def test_results(hall: pt.Scene, hall_plan: pt.Plan) -> None:
    rehearsal = pt.rehearse(hall, hall_plan)
    execution = pt.run(hall, hall_plan, trials=1)
    curve = pt.length_curve(hall, points=2)
    for result in (rehearsal, execution, curve, hall_plan.certificate, hall_plan.cost):
        again = pickle.loads(pickle.dumps(result))
        assert again.to_dict() == result.to_dict()
