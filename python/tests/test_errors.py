"""What goes wrong is an exception that knows all about it."""

from __future__ import annotations

import pickle

import pytest

import pairtrawl as pt
from pairtrawl import _native


def test_a_proof_comes_with_the_exception(hall: pt.Scene) -> None:
    with pytest.raises(pt.InfeasibleError, match="proven infeasible") as refused:
        pt.plan(hall, net_length=0.5)
    (proof,) = refused.value.proofs
    assert proof.kind == "net_too_short"
    assert proof.object is None
    assert "<svg" in (refused.value.svg() or "")


def test_a_proof_about_an_object_says_where_it_should_lie(hall: pt.Scene) -> None:
    hall.add_obstacle(box=(1.8, 2.7, 2.2, 3.0))
    hall.add_object((2.0, 2.65), radius=0.03)
    with pytest.raises(pt.InfeasibleError) as refused:
        pt.plan(hall)
    (proof,) = refused.value.proofs
    assert (proof.kind, proof.object) == ("object_pinned", 1)
    assert proof.move_to is not None and proof.move_distance is not None and proof.move_distance > 0
    assert "leave" in (refused.value.help or "")
    plan = pt.plan(hall, leave="unreachable", rehearsal="skip")
    (left,) = plan.left_out
    assert (left.object, left.why) == (1, "proven")


def no_plan(hall: pt.Scene) -> pt.NoPlanError:
    """Robots that must face along the way find none around a wall, although nothing proves that there is none."""
    hall.set_planner(max_skew=0.2)
    hall.add_obstacle(box=(1.0, 0.0, 1.2, 1.2))
    for place in ((1.8, 0.75), (1.8, 2.2)):
        hall.add_object(place, radius=0.03)
    with pytest.raises(pt.NoPlanError) as refused:
        pt.plan(hall, rehearsal="skip", orders=2, rounds=1, centerline="hybrid-a-star", explore=False)
    return refused.value


def test_a_search_without_success_says_what_fails(hall: pt.Scene) -> None:
    error = no_plan(hall)
    assert len(error.tried) > 1
    assert error.claim is not None and not error.claim.holds and error.claim.margin < 0
    assert error.place == error.claim.place
    assert error.best is not None and error.claim.name in {claim.name for claim in error.best.certificate.failed}
    assert error.svg() is not None
    assert not isinstance(error, ValueError)


def test_the_time_limit(paper: pt.Scene) -> None:
    with pytest.raises(pt.TimeLimitError) as late:
        pt.plan(paper, time_limit=1e-3)
    assert late.value.details["limit"] == 1e-3
    assert late.value.details["stage"]


def test_exceptions_pickle_with_their_pictures(hall: pt.Scene) -> None:
    try:
        pt.plan(hall, net_length=0.5)
    except pt.InfeasibleError as caught:
        error = caught
    again = pickle.loads(pickle.dumps(error))
    assert type(again) is pt.InfeasibleError
    assert again.proofs == error.proofs
    assert (again.message, again.help, again.svg()) == (error.message, error.help, error.svg())
    found = no_plan(hall)
    once_more = pickle.loads(pickle.dumps(found))
    assert (once_more.tried, once_more.claim, once_more.best) == (found.tried, found.claim, found.best)


def test_a_panic_is_an_exception() -> None:
    with pytest.raises(pt.InternalError, match="a planted fault"):
        _native._panic("a planted fault")
