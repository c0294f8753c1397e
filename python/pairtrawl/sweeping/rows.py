"""One row for each plan: what workers compute, and the columns that a table has."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from pairtrawl._native import Plan
from pairtrawl.errors import PairtrawlError
from pairtrawl.planning import plan_batch
from pairtrawl.sweeping.jobs import Job, Options

if TYPE_CHECKING:
    import pyarrow as pa

Row = dict[str, Any]

CLAIMS = (
    "scene",
    "net_length",
    "endpoints",
    "step",
    "turn",
    "forward",
    "no_sideways_slip",
    "speed",
    "abreast",
    "robot_clearance",
    "robots_miss_objects",
    "net_encloses_no_obstacle",
    "every_object_covered",
    "separation",
    "net_reach",
    "inside_area",
    "robots_apart",
)
"""All claims, as the file format names them: each has a column `margin_...`."""

# Columns that say what came out; an option of the same name says what was wanted where there is no plan.
_RESULTS = {
    "net_length": "float64",
    "total": "float64",
    "smoothness": "float64",
    "distance": "float64",
    "obstacle": "float64",
    "expansion": "float64",
    "valid": "bool_",
    "objects": "int64",
    "gathered": "int64",
    "waypoints": "int64",
    "duration": "float64",
    "left_length": "float64",
    "right_length": "float64",
    "rehearsed": "string",
    "status": "string",
    "iterations": "int64",
    **{f"margin_{claim}": "float64" for claim in CLAIMS},
    "warnings": "string",
    "digest": "string",
    "seconds": "float64",
    "error_type": "string",
    "error": "string",
}


def compute(batch: list[Job], threads: int | None = 1) -> list[Row]:
    """Plans a batch: this is what a worker does. A failure is a row as well."""
    each = [job.options for job in batch]
    results = plan_batch([job.scene for job in batch], each=each, threads=threads)
    return [row_of(job, result) for job, result in zip(batch, results)]


def lost(job: Job, why: str) -> Row:
    """The row of a plan whose workers died, again and again."""
    return row_of(job, PairtrawlError(why))


def row_of(job: Job, result: Plan | PairtrawlError) -> Row:
    """The row of a plan, or of what came instead."""
    scene = {"key": job.key, "scene": job.scene.name, "scene_sha256": job.scene.sha256}
    outcome = _of_error(job, result) if isinstance(result, PairtrawlError) else _of_plan(result)
    return {**scene, **job.options, **outcome, "objects": len(job.scene.objects)}


def _of_error(job: Job, error: PairtrawlError) -> Row:
    wanted = job.options.get("net_length", job.scene.net_length)
    return {
        "net_length": float(wanted) if isinstance(wanted, (int, float)) else None,
        "valid": False,
        "seconds": error.seconds,
        "error_type": type(error).__name__,
        "error": error.message,
    }


def _of_plan(plan: Plan) -> Row:
    cost, certificate = plan.cost, plan.certificate
    left, right = plan.path_lengths
    return {
        "net_length": plan.net_length,
        "total": cost.total,
        "smoothness": cost.smoothness,
        "distance": cost.distance,
        "obstacle": cost.obstacle,
        "expansion": cost.expansion,
        "valid": certificate.valid,
        "gathered": len(plan.scene.objects) - len(plan.left_out),
        "waypoints": len(plan),
        "duration": plan.duration,
        "left_length": left,
        "right_length": right,
        "rehearsed": plan.rehearsal.status,
        "status": plan.solver.status,
        "iterations": plan.solver.iterations,
        **{f"margin_{claim.name}": claim.margin for claim in certificate},
        "warnings": "; ".join(plan.warnings) or None,
        "digest": plan.digest,
        "seconds": sum(plan.stages.values()),
    }


def schema(options: list[Options]) -> pa.Schema:
    """The columns of a sweep: the scene, what was swept, what came out."""
    import pyarrow as pa

    columns = {"key": pa.string(), "scene": pa.string(), "scene_sha256": pa.string()}
    for name in dict.fromkeys(name for chosen in options for name in chosen):
        if name not in _RESULTS:
            columns[name] = _type([chosen.get(name) for chosen in options])
    columns.update({name: getattr(pa, kind)() for name, kind in _RESULTS.items()})
    return pa.schema(list(columns.items()))


def _type(values: list[Any]) -> pa.DataType:
    import pyarrow as pa

    kinds = {type(value) for value in values if value is not None}
    if kinds == {bool}:
        return pa.bool_()
    if kinds == {int}:
        return pa.int64()
    if kinds <= {int, float} and kinds:
        return pa.float64()
    return pa.string()
