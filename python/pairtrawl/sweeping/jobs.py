"""What a sweep has to plan: every scene with every set of options, one after the other, in batches."""

from __future__ import annotations

import functools
import hashlib
import itertools
import json
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass
from importlib.metadata import version
from os import PathLike
from typing import Any, Union

from pairtrawl._native import Scene
from pairtrawl.errors import InputError

Options = dict[str, Any]
SceneLike = Union[Scene, str, "PathLike[str]"]


@dataclass(frozen=True)
class Job:
    """One plan to be made."""

    key: str
    """The same for the same scene, options and version: what is known of it need not be computed again."""
    scene: Scene
    options: Options


def grid(parameters: Mapping[str, Any], table: Iterable[Mapping[str, Any]] | None) -> list[Options]:
    """Sets of options: those of the table, each with every combination of the parameters' values."""
    values = {name: _values(value) for name, value in parameters.items()}
    for name, listed in values.items():
        if not listed:
            raise InputError(f"{name} has no values: give at least one, or leave it out")
    rows = [{}] if table is None else [_present(row) for row in table]
    products = [dict(zip(values, chosen)) for chosen in itertools.product(*values.values())]
    return [{**row, **chosen} for row in rows for chosen in products]


def _values(value: Any) -> list[Any]:
    """What is to be tried: a list, an array and the like have several, anything else is one."""
    if isinstance(value, (str, bytes)) or not isinstance(value, Iterable):
        return [value]
    return [_scalar(one) for one in value]


def _scalar(value: Any) -> Any:
    """Numbers of numpy as those of Python."""
    return value.item() if hasattr(value, "item") else value


def _present(row: Mapping[str, Any]) -> Options:
    """Without what is None or NaN: an empty cell of a table."""
    scalars = {str(name): _scalar(value) for name, value in row.items()}
    return {name: value for name, value in scalars.items() if value is not None and value == value}


def jobs(scenes: Iterable[SceneLike], options: Collection[Options]) -> Iterator[Job]:
    """Every scene with every set of options. Scenes may come from a generator, and files are read when their turn comes."""
    for given in scenes:
        scene = given if isinstance(given, Scene) else Scene.from_file(given)
        # A scene that is edited while the sweep goes on is another one.
        scene = scene.copy()
        for chosen in options:
            yield Job(_key(scene, chosen), scene, chosen)


def _key(scene: Scene, options: Options) -> str:
    said = json.dumps([_version(), scene.sha256, options], sort_keys=True)
    return hashlib.sha256(said.encode()).hexdigest()[:32]


@functools.cache
def _version() -> str:
    return version("pairtrawl")


def batches(todo: Iterable[Job], size: int) -> Iterator[list[Job]]:
    """Jobs in lists of so many; the last one may have fewer."""
    source = iter(todo)
    while batch := list(itertools.islice(source, size)):
        yield batch
