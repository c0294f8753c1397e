"""Scenes: read, made, edited, written."""

from __future__ import annotations

import copy
from pathlib import Path

import numpy as np
import pytest

import pairtrawl as pt
from conftest import HALL, ROOT


def test_a_file_keeps_its_text_and_its_hash(paper: pt.Scene, tmp_path: Path) -> None:
    path = ROOT / "scenes/paper-experiment/scene.toml"
    assert paper.to_toml() == path.read_text()
    paper.save(tmp_path / "scene.toml")
    again = pt.Scene.from_file(tmp_path / "scene.toml")
    assert again == paper
    assert again.sha256 == paper.sha256


def test_text_dictionary_and_back(hall: pt.Scene) -> None:
    assert pt.Scene.from_toml(hall.to_toml()) == hall
    assert pt.Scene.from_dict(hall.to_dict()) == hall
    assert hall.to_dict()["objects"] == HALL["objects"]


def test_numpy_numbers_and_arrays_are_numbers_and_lists() -> None:
    scene = pt.Scene.from_dict(
        {
            **HALL,
            "objects": [{"position": np.array([2.0, 1.5]), "radius": np.float32(0.03125), "mass": np.float64(0.1)}],
            "planner": {"waypoints": np.int64(70)},
            "net": {"length": None},
        }
    )
    assert scene.object_radii[0] == 0.03125
    assert scene.to_dict()["planner"] == {"waypoints": 70}


def test_edits_are_in_place_and_checked(hall: pt.Scene) -> None:
    before = hall.copy()
    hall.add_object((1.0, 1.4), size=(0.05, 0.05), mass=0.02)
    hall.add_object(np.array([3.0, 1.6]), radius=0.02)
    hall.add_obstacle(box=(1.8, 2.7, 2.2, 3.0))
    hall.add_obstacle(polygon=np.array([[0.0, 0.0], [0.4, 0.0], [0.0, 0.4]]))
    hall.add_obstacle(circle=[3.9, 0.1, 0.1])
    hall.set_net(length=1.3)
    hall.set_robot(radius=0.2)
    hall.set_planner(clearance=0.04)
    hall.set_start((0.6, 1.85), (0.6, 1.15), 0.0)
    hall.name = "furnished"
    assert hall.objects.tolist() == [[2.0, 1.5], [1.0, 1.4], [3.0, 1.6]]
    assert [list(one) for one in hall.obstacles] == [["box"], ["polygon"], ["circle"]]
    assert (hall.net_length, hall.robot_radius, hall.name) == (1.3, 0.2, "furnished")
    assert hall.start[0].tolist() == [0.6, 1.85, 0.0]
    assert hall != before
    assert len(before.objects) == 1
    hall.set_net(length=None)
    hall.remove_object(1)
    assert hall.net_length is None
    assert len(hall.objects) == 2
    assert pt.plan(hall, rehearsal="skip").certificate.valid


def test_a_change_that_makes_no_sense_leaves_the_scene_as_it_was(hall: pt.Scene) -> None:
    before = hall.copy()
    with pytest.raises(pt.InputError, match=r"objects\[1\]\.radius"):
        hall.add_object((1.0, 1.5), radius=-1.0)
    with pytest.raises(pt.InputError, match="radius"):
        hall.set_robot(radus=0.2)
    with pytest.raises(IndexError, match="obstacles has 0 elements"):
        hall.remove_obstacle(0)
    with pytest.raises(TypeError, match="is a"):
        hall.set_net(length=object())
    assert hall == before


def test_copies_are_their_own(hall: pt.Scene) -> None:
    for made in (hall.copy(), copy.copy(hall), copy.deepcopy(hall)):
        made.set_net(length=1.2)
        assert hall.net_length is None


def test_errors_name_file_and_line(tmp_path: Path) -> None:
    with pytest.raises(pt.InputError, match="no such file") as missing:
        pt.Scene.from_file(tmp_path / "scene.toml")
    assert missing.value.details["file"].endswith("scene.toml")
    (tmp_path / "scene.toml").write_text('format = "pairtrawl-scene/1"\nnmae = "x"\n')
    with pytest.raises(pt.InputError, match="nmae") as unknown:
        pt.Scene.from_file(tmp_path / "scene.toml")
    assert unknown.value.details["line"] == 2
    assert isinstance(unknown.value, ValueError)
    with pytest.raises(pt.FileAccessError):
        pt.Scene.from_dict(HALL).save(tmp_path / "nowhere" / "scene.toml")


def test_a_map_comes_along(tmp_path: Path) -> None:
    scene = pt.Scene.from_file(ROOT / "scenes/nav2-sandbox/scene.toml")
    rings = scene.free_rings
    assert rings is not None
    assert all(ring.shape[1] == 2 for ring in rings)
    litter = pt.generate("litter", map=ROOT / "scenes/nav2-sandbox/map.yaml", objects=3, seed=1)
    assert len(litter.objects) == 3
    litter.add_object(litter.objects[0] + 0.1, radius=0.02)
    assert litter.free_rings is not None


def test_generated_scenes_are_the_same_again() -> None:
    assert pt.generate(seed=3, difficulty=2) == pt.generate(seed=3, difficulty=2)
    assert pt.generate(seed=3) != pt.generate(seed=4)
    assert pt.generate("hall", objects=5, seed=2).objects.shape == (5, 2)
    assert "serpentine" in pt.generate("serpentine", waypoints=400).name
    for bad in ({"difficulty": 11}, {"waypoints": 3}, {"kind": "cave"}, {"kind": "litter"}, {"kind": "hall", "near": -1.0}):
        with pytest.raises(pt.InputError):
            pt.generate(**bad)  # type: ignore[arg-type]


def test_pictures(hall: pt.Scene) -> None:
    assert hall._repr_html_().startswith("<svg")
    assert repr(hall) == "<Scene \"small hall\": 1 objects, 0 obstacles>"
