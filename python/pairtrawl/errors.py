"""What can go wrong. Every exception carries the program's details: what it is about, and what would help."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from pairtrawl._native import Failure, Plan
    from pairtrawl.results import Claim, Proof

__all__ = [
    "FileAccessError",
    "InfeasibleError",
    "InputError",
    "InternalError",
    "NoPlanError",
    "PairtrawlError",
    "PlanningError",
    "TimeLimitError",
]


class PairtrawlError(Exception):
    """Anything that went wrong here."""

    message: str
    """One clear message: the thing, the value, the bound."""
    help: str | None
    """What to do about it, where the message does not say so itself."""
    details: dict[str, Any]
    """What it is about, for programs: file and line, limit and stage."""
    seconds: float | None = None
    """Time that planning took, s; set where a batch was planned."""

    def __init__(self, message: str, *, help: str | None = None, details: dict[str, Any] | None = None) -> None:
        super().__init__(message)
        self.message = message
        self.help = help
        self.details = details or {}

    def __str__(self) -> str:
        return f"{self.message}\n  help: {self.help}" if self.help else self.message


class InputError(PairtrawlError, ValueError):
    """A scene, a plan or an argument that cannot be used, whatever the planner does."""


class FileAccessError(PairtrawlError, OSError):
    """The system refuses a file: permission, disk."""


class InternalError(PairtrawlError, RuntimeError):
    """A fault of the library: please report it with the scene."""


class PlanningError(PairtrawlError):
    """There is no plan: proven, not found, or not in time."""

    _failure: Failure | None
    _pictures: tuple[str | None, str | None]

    def __init__(
        self,
        message: str,
        *,
        help: str | None = None,
        details: dict[str, Any] | None = None,
        failure: Failure | None = None,
    ) -> None:
        super().__init__(message, help=help, details=details)
        self._failure = failure
        self._pictures = (None, None)

    def svg(self) -> str | None:
        """The map with what is in the way, as SVG. It shows no plan."""
        return self._failure.svg() if self._failure is not None else self._pictures[0]

    def html(self) -> str | None:
        """The page about it, as HTML: the map, what was tried, what fails where."""
        return self._failure.html() if self._failure is not None else self._pictures[1]

    def _repr_html_(self) -> str | None:
        return self.svg()

    def __reduce__(self) -> tuple[Any, ...]:
        # What the pictures are drawn from stays here: the pictures go along.
        state = dict(self.__dict__, _failure=None, _pictures=(self.svg(), self.html()))
        return type(self), (self.message,), state


class InfeasibleError(PlanningError):
    """There are proofs that no plan exists, or none that gathers everything."""

    proofs: list[Proof]
    """One that is not about an object first, then those about objects."""

    def __init__(self, message: str, *, proofs: list[Proof] | None = None, **others: Any) -> None:
        super().__init__(message, **others)
        self.proofs = proofs or []


class NoPlanError(PlanningError):
    """No certified plan was found within the budget. That is no proof that there is none."""

    claim: Claim | None
    """The claim that fails in the best attempt; None where it did not come so far."""
    place: tuple[float, float] | None
    """Where it fails, m."""
    tried: list[tuple[str, str]]
    """Every start that was tried, and what was missing there."""
    could_leave: list[int]
    """Objects without which there is a certified plan."""
    best: Plan | None
    """The best attempt, for pictures: it is no plan."""

    def __init__(
        self,
        message: str,
        *,
        claim: Claim | None = None,
        place: tuple[float, float] | None = None,
        tried: list[tuple[str, str]] | None = None,
        could_leave: list[int] | None = None,
        best: Plan | None = None,
        **others: Any,
    ) -> None:
        super().__init__(message, **others)
        self.claim = claim
        self.place = place
        self.tried = tried or []
        self.could_leave = could_leave or []
        self.best = best


class TimeLimitError(PlanningError):
    """The time limit ran out: `details` has the limit in s and the stage at work."""
