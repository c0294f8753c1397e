"""Rehearsals and drives."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import pairtrawl as pt


def test_a_rehearsal_has_shapes(paper: pt.Scene, paper_plan: pt.Plan) -> None:
    rehearsal = pt.rehearse(paper, paper_plan)
    assert rehearsal.passed and all(rehearsal.gathered)
    count, objects = len(rehearsal.times), len(paper.objects)
    assert rehearsal.left.shape == rehearsal.right.shape == (count, 3)
    assert rehearsal.net.shape[0] == count and rehearsal.net.shape[2] == 2
    assert rehearsal.objects.shape == (count, objects, 3)
    assert rehearsal.tension.shape == rehearsal.drive_force.shape == (count, 2)
    # The net begins and ends at the hitches.
    hitch = rehearsal.left[:, :2] - paper.hitch * np.stack(
        [np.cos(rehearsal.left[:, 2]), np.sin(rehearsal.left[:, 2])], axis=1
    )
    assert np.allclose(rehearsal.net[:, 0], hitch, atol=2e-3)
    assert np.allclose(rehearsal.objects[0, :, :2], paper.objects, atol=1e-9)
    record = paper_plan.rehearsal_record
    assert record is not None and np.array_equal(record.net, rehearsal.net)
    fine = pt.rehearse(paper, paper_plan, frame_interval=0.5)
    assert len(fine.times) < count
    with pytest.raises(pt.InputError, match="time_step"):
        pt.rehearse(paper, paper_plan, time_step=-1.0)


def test_drives(hall: pt.Scene, hall_plan: pt.Plan, tmp_path: Path) -> None:
    run = pt.run(hall, hall_plan, trials=2, seed=3, object_mass=(0.02, 0.05), robot_mass=1.1, output=tmp_path / "run")
    assert run.gathered_everything and len(run.trials) == 2
    trial = run.trials[1]
    assert 0.02 <= trial.conditions["object_masses"][0] <= 0.05
    assert trial.conditions["robot_mass_factor"] == 1.1
    assert trial.error.shape == (len(trial.sample_times), 2)
    assert trial.torque.shape == (len(trial.sample_times), 2, 2)
    assert trial.tracking_max[0] >= trial.tracking_rms[0] > 0
    names = {path.name for path in (tmp_path / "run").iterdir()}
    assert names == {"execution.json", "report.html", "run.mcap", "metadata.yaml"}
    run.save(tmp_path / "execution.json")
    assert json.loads((tmp_path / "execution.json").read_text()) == run.to_dict()
    again = pt.run(hall, hall_plan, trials=2, seed=3, object_mass=(0.02, 0.05), robot_mass=1.1, threads=1)
    assert np.array_equal(again.trials[1].left, trial.left)


def test_options_of_drives(hall: pt.Scene, hall_plan: pt.Plan) -> None:
    other = pt.run(hall, hall_plan, trials=1, controller="integral", nominal_inertia="robot", position_noise=0.0)
    assert other.controller == "integral"
    still = pt.run(hall, hall_plan, trials=1, adapt=[], feedback=1.2, stop_error=0.5)
    assert not np.array_equal(still.trials[0].left, pt.run(hall, hall_plan, trials=1).trials[0].left)
    for bad in ({"controller": "hope"}, {"adapt": ["mood"]}, {"rates": -1.0}, {"trials": 0}, {"friction": (2.0, 1.0)}, {"robot_mass": -1.0}):
        with pytest.raises(pt.InputError):
            pt.run(hall, hall_plan, **bad)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="no option"):
        pt.run(hall, hall_plan, wind=3.0)  # type: ignore[call-arg]


def test_an_unproven_plan_is_not_driven(hall: pt.Scene, hall_plan: pt.Plan, tmp_path: Path) -> None:
    hall_plan.save(tmp_path / "plan.json")
    changed = hall.copy()
    changed.add_object((2.0, 2.9), radius=0.02)
    other = pt.Plan.from_file(tmp_path / "plan.json", changed)
    with pytest.raises(pt.InputError, match="every_object_covered"):
        pt.run(changed, other, trials=1)
    assert not pt.run(changed, other, trials=1, unproven=True).gathered_everything
