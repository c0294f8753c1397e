"""Options by keyword, as the functions take them. What is left out, or None, has its default."""

from __future__ import annotations

from typing import Literal, TypedDict, Union

Range = Union[float, tuple[float, float]]
"""A number, or what is drawn between in each trial, the lower first."""


class PlanOptions(TypedDict, total=False):
    """Options of planning."""

    net_length: float | Literal["auto"] | None
    """Length of the net, m, instead of the scene's; `"auto"`: the planner chooses it."""
    waypoints: int | None
    """Number of waypoints N instead of one that follows from the path length."""
    order: Literal["shortest", "given"] | None
    """Visiting order: the shortest (default), or the scene's own."""
    orders: int | None
    """Greatest number of visiting orders, 3 by default."""
    explore: bool | None
    """Whether several starts are optimized and the best one counts (default), or the first one alone."""
    centerline: Literal["hybrid-a-star", "rrt-star"] | None
    """How the centerline is searched; left out: hybrid A*, and RRT* when that leads to no plan."""
    method: Literal["joint", "alternating", "alternating-bounded"] | None
    """How the trajectories are optimized: both robots and the net at once (default), or the paper's Algorithm 1."""
    tolerance: float | None
    """Polishes the plan to this relative KKT residual, from 1e-9 to 1e-3; left out: within about 1e-4 of the optimum nearby."""
    seed: int | None
    """Of whatever is random: the centerline by RRT*."""
    time_limit: float | None
    """Stops after so many seconds with the certified plan at hand, without one with `TimeLimitError`. The only option that makes
    results depend on the machine."""
    leave: Literal["none", "unreachable"] | None
    """What is done with objects that cannot be gathered: refuse the whole plan, or leave them and gather the rest."""
    rehearsal: bool | Literal["skip", "report", "require"] | None
    """Whether the plan is rehearsed in physics: no, yes with a warning where it fails (default), or no plan without it."""
    rounds: int | None
    """Greatest number of optimizations from one start, 6 by default."""
    rehearsal_rounds: int | None
    """Greatest number of further plans when a rehearsal fails, 3 by default."""


class RunOptions(TypedDict, total=False):
    """Options of driving."""

    controller: Literal["mrac", "integral", "model-based"] | None
    """The control law: adaptive (default), with integral feedback, or eq. 22 as printed."""
    trials: int | None
    """How many drives, 5 by default."""
    seed: int | None
    """The same seed gives the same drives."""
    robot_mass: Range | None
    """Mass of the robots over the scene's."""
    robot_inertia: Range | None
    """Inertia of the robots over the scene's."""
    object_mass: Range | None
    """Mass of each object, kg, instead of the scene's."""
    payload: float | None
    """Mass of all objects together, kg: scales their masses."""
    friction: Range | None
    """Friction of net and objects on the floor over the scene's."""
    pose_delay: Range | None
    """Age of poses, s."""
    velocity_delay: Range | None
    """Age of measured velocities, s."""
    odometry_scale: Range | None
    """Measured over true speed."""
    position_noise: float | None
    """Standard deviation of measured positions, m."""
    heading_noise: float | None
    """Standard deviation of measured headings, rad."""
    feedback: float | None
    """Velocity feedback of the adaptive and the integral law, times the default."""
    rates: float | None
    """Rates of adaptation, or the integral gain, times the defaults."""
    adapt: list[Literal["state", "input", "bias"]] | None
    """What the adaptive law adapts: all by default; an empty list: nothing."""
    torque_limit: float | None
    """Greatest torque that controllers command to a wheel, N m, instead of the scene's."""
    stop_error: float | None
    """Stops the pair when a robot is this far from its path, m, instead of 0.25."""
    nominal_inertia: Literal["table", "robot"] | None
    """Inertia in the controllers' model: the paper's table (default), or the scene's robot."""
    sample_interval: float | None
    """Time between two samples of the controllers that are kept, s."""
    unproven: bool | None
    """Whether a plan that cannot be proven is driven as well."""
