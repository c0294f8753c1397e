"""Progress: a callback that takes events, or `True` for a bar of tqdm."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, Union

__all__ = ["Progress", "ProgressEvent"]


@dataclass(frozen=True)
class ProgressEvent:
    """Something that is reported while work goes on. It is reported on the calling thread."""

    kind: str
    """`started` and `finished`: a stage; `noted`: words for people; `done`: one of many."""
    stage: str | None = None
    """The stage of planning, such as `optimize`."""
    round: int | None = None
    """Rises from 1 when the planner tries again."""
    seconds: float | None = None
    """Time that the stage took, s."""
    message: str | None = None
    """The words."""
    index: int | None = None
    """Which one of many is done."""


Progress = Union[bool, Callable[[ProgressEvent], object], None]
"""None or False: nothing is reported."""


@contextmanager
def reporting(progress: Progress, total: int | None = None, what: str = "") -> Iterator[Callable[..., object] | None]:
    """What the library calls: a callback of keywords for a progress as users give it; `total` of how many."""
    if progress is None or progress is False:
        yield None
    elif progress is True:
        with _bar(total, what) as report:
            yield lambda **event: report(ProgressEvent(**event))
    else:
        callback = progress
        yield lambda **event: callback(ProgressEvent(**event))


@contextmanager
def _bar(total: int | None, what: str) -> Iterator[Callable[[ProgressEvent], object]]:
    from tqdm.auto import tqdm

    with tqdm(total=total, desc=what) as bar:

        def report(event: ProgressEvent) -> Any:
            if event.kind == "done":
                bar.update()
            elif event.kind == "finished" and total is None:
                bar.update()
            elif event.kind == "started" and total is None:
                again = f", round {event.round}" if event.round and event.round > 1 else ""
                bar.set_description(f"{what}: {event.stage}{again}")
            elif event.kind == "noted":
                bar.write(event.message or "")

        yield report
