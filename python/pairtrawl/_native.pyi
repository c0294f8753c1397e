"""
What is written in Rust. Use `pairtrawl`, which documents it.
"""

from _typeshed import SupportsGetItem, SupportsLenAndGetItem
from collections.abc import Callable, Mapping
from numpy import float64
from numpy.typing import ArrayLike, NDArray
from os import PathLike
from pairtrawl.errors import PairtrawlError
from pairtrawl.results import Certificate, Circle, Cost, Curve, Execution, LeftOut, LengthCurve, Rehearsal, Solver, Verdict
from typing import Any, SupportsFloat, SupportsIndex, final

__all__ = ["Failure", "Plan", "Scene", "_panic", "_restore_plan", "_restore_scene", "check", "generate_hall", "generate_litter", "generate_solvable", "length_curve", "plan", "plan_batch", "rehearse", "replan", "run"]

@final
class Failure:
    """
    What a picture of a failed search is drawn from. Exceptions carry it; see `PlanningError.svg`.
    """
    def html(self, /) -> str | None:
        """
        The page about it, as HTML; None where there is nothing to see.
        """
    def svg(self, /) -> str | None:
        """
        The map with what is in the way, as SVG; None where there is nothing to see.
        """

@final
class Plan:
    """
    A planned run: what both robots drive, and how it came about.

    Arrays are read-only and made once: two reads of `plan.left` give the same array, slices are views, and an array that is
    kept outlives its plan. SI units, radians, map frame; left and right as seen by someone who walks behind the pair.
    """
    def __eq__(self, other: object, /) -> bool:
        """
        True when two plans say the same, bit for bit, but for the seconds.
        """
    def __len__(self, /) -> int: ...
    def __reduce__(self, /) -> tuple[Any, ...]: ...
    def __repr__(self, /) -> str: ...
    def _repr_html_(self, /) -> str: ...
    @property
    def baseline_left(self, /) -> NDArray[float64]:
        """
        What the optimization of the left robot started from, N x 3.
        """
    @property
    def baseline_right(self, /) -> NDArray[float64]:
        """
        What the optimization of the right robot started from, N x 3.
        """
    @property
    def centerline(self, /) -> NDArray[float64]:
        """
        The pair's centerline, M x 3.
        """
    @property
    def certificate(self, /) -> Certificate:
        """
        The proof, claim by claim.
        """
    @property
    def circles(self, /) -> list[Circle]:
        """
        Circles around the objects; close ones share one.
        """
    @property
    def cost(self, /) -> Cost:
        """
        J and its terms.
        """
    def curves(self, /) -> list[Curve]:
        """
        Everything over time that reports show, such as separation and clearance, by key.
        """
    @property
    def digest(self, /) -> str:
        """
        SHA-256 of everything that the plan file says but the seconds: two plans with the same digest are the same, bit for bit.
        """
    @property
    def duration(self, /) -> float:
        """
        Time to drive, s.
        """
    @staticmethod
    def from_file(path: str | PathLike[str], scene: Scene) -> Plan:
        """
        Reads a plan file, and judges it against a scene: its certificate and cost are derived anew.
        """
    @property
    def left(self, /) -> NDArray[float64]:
        """
        Poses of the left robot, N x 3: x and y in m, heading in rad.
        """
    @property
    def left_out(self, /) -> list[LeftOut]:
        """
        Objects that stay where they are, and why.
        """
    @property
    def net_length(self, /) -> float:
        """
        Length of the net, d_max, m.
        """
    @property
    def order(self, /) -> list[int]:
        """
        Visiting order: indices into `circles`.
        """
    @property
    def path_lengths(self, /) -> tuple[float, float]:
        """
        Driven lengths of the left and the right robot, m.
        """
    @property
    def rehearsal(self, /) -> Verdict:
        """
        What the rehearsal in physics said. Never a proof.
        """
    @property
    def rehearsal_record(self, /) -> Rehearsal | None:
        """
        The rehearsal in full, with robots, net and objects over time; None when there was none.
        """
    @property
    def right(self, /) -> NDArray[float64]:
        """
        Poses of the right robot, N x 3; row i belongs to the same instant as row i of `left`.
        """
    def save(self, /, path: str | PathLike[str]) -> None:
        """
        Writes the plan. The ending says what: .json the plan file, .csv the smooth curve that is driven, .svg the map, .html the
        report. A path without an ending is a folder that gets all of them, as from the program.
        """
    @property
    def scene(self, /) -> Scene:
        """
        The scene as it was planned for.
        """
    @property
    def solver(self, /) -> Solver:
        """
        How the optimization ended.
        """
    @property
    def stages(self, /) -> dict[str, Any]:
        """
        Seconds by stage of planning.
        """
    @property
    def step_time(self, /) -> float:
        """
        Time from one waypoint to the next where the file format is linear in time, s. The drive itself follows `times`.
        """
    def svg(self, /) -> str:
        """
        The map with the plan, as SVG.
        """
    def swept_at(self, /) -> list[float | None]:
        """
        When the line between the robots first sweeps each object, s; None where it does not.
        """
    @property
    def times(self, /) -> NDArray[float64]:
        """
        When the pair passes each waypoint, N, s.
        """
    def to_dict(self, /) -> dict[str, Any]:
        """
        The plan file as a dictionary.
        """
    def to_json(self, /) -> str:
        """
        The text of the plan file, format pairtrawl-plan/1.
        """
    @property
    def warnings(self, /) -> list[str]:
        """
        What a person should know about the plan.
        """
    def waypoint_at(self, /, time: SupportsFloat | SupportsIndex) -> int:
        """
        The last waypoint that a pair which keeps to the plan has passed `time` s after it set out.
        """

@final
class Scene:
    """
    Everything that a run is planned from: area, obstacles, objects, start and end, robot and net. SI units, radians, map frame.

    Make one with `Scene.from_file`, `Scene.from_toml` or `Scene.from_dict`. The methods `add_...`, `remove_...` and `set_...` change
    it in place and check it as a whole: a change that makes no sense raises `InputError` and leaves the scene as it was.
    """
    def __copy__(self, /) -> Scene: ...
    def __deepcopy__(self, /, _memo: dict[str, Any]) -> Scene: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __reduce__(self, /) -> tuple[Any, ...]: ...
    def __repr__(self, /) -> str: ...
    def _repr_html_(self, /) -> str: ...
    def add_object(self, /, position: ArrayLike, *, size: ArrayLike | None = None, radius: SupportsFloat | SupportsIndex | None = None, mass: SupportsFloat | SupportsIndex | None = None) -> None:
        """
        Puts an object there, to be gathered: its center (x, y), its size (width, depth) or radius, m; its mass, kg.
        """
    def add_obstacle(self, /, *, box: ArrayLike | None = None, polygon: ArrayLike | None = None, circle: ArrayLike | None = None) -> None:
        """
        Puts an obstacle there: box = (xmin, ymin, xmax, ymax), polygon = ((x, y), ...) or circle = (x, y, radius), m.
        """
    @property
    def bounds(self, /) -> NDArray[float64]:
        """
        Bounds of the area, 2 x 2: the lower left and the upper right corner, m.
        """
    def copy(self, /) -> Scene:
        """
        A scene of its own with the same content.
        """
    @property
    def end(self, /) -> NDArray[float64]:
        """
        Poses of the left and the right robot at the end, 2 x 3.
        """
    @property
    def free_rings(self, /) -> list[NDArray[float64]] | None:
        """
        The boundary of a map's free floor as closed rings, each N x 2, m, to be filled by the even-odd rule; None without a map.
        """
    @staticmethod
    def from_dict(scene: Mapping[str, Any]) -> Scene:
        """
        Makes a scene of a dictionary with the keys of a scene file. `format` may be left out; numpy's numbers and arrays are
        taken as numbers and lists, None as a key that is left out. A map is read relative to the current folder.
        """
    @staticmethod
    def from_file(path: str | PathLike[str]) -> Scene:
        """
        Reads a scene file, format pairtrawl-scene/1, and the map that it names.
        """
    @staticmethod
    def from_toml(text: str, *, folder: str | PathLike[str] | None = None) -> Scene:
        """
        Reads a scene from the text of a scene file. Paths in it are relative to `folder`; left out, it must name no map.
        """
    @property
    def hitch(self, /) -> float:
        """
        How far behind the axle center the net is tied, m.
        """
    @property
    def name(self, /) -> str:
        """
        A name for people.
        """
    @name.setter
    def name(self, /, name: str) -> None: ...
    @property
    def net_length(self, /) -> float | None:
        """
        Length of the net, m; None: the planner chooses it.
        """
    @property
    def object_radii(self, /) -> NDArray[float64]:
        """
        Radius of the smallest circle around each object's footprint, N, m.
        """
    @property
    def objects(self, /) -> NDArray[float64]:
        """
        Centers of the objects, N x 2, m.
        """
    @property
    def obstacles(self, /) -> list[dict[str, Any]]:
        """
        The obstacles, each a dictionary with one key: box = [xmin, ymin, xmax, ymax], polygon = [[x, y], ...] or
        circle = [x, y, radius], m.
        """
    def remove_object(self, /, index: SupportsIndex) -> None:
        """
        Takes an object away, by its index.
        """
    def remove_obstacle(self, /, index: SupportsIndex) -> None:
        """
        Takes an obstacle away, by its index.
        """
    @property
    def robot_radius(self, /) -> float:
        """
        Radius of the circle around the axle center that contains a robot, m.
        """
    def save(self, /, path: str | PathLike[str]) -> None:
        """
        Writes the scene file; with a map, its files must lie where the scene names them.
        """
    def set_area(self, /, **keys: "object") -> None:
        """
        Sets keys of `[area]`, such as min, max, resolution; None removes a key.
        """
    def set_end(self, /, left: ArrayLike, right: ArrayLike, heading: SupportsFloat | SupportsIndex | None = None, *, left_heading: SupportsFloat | SupportsIndex | None = None, right_heading: SupportsFloat | SupportsIndex | None = None) -> None:
        """
        Sets where the pair ends, as `set_start`.
        """
    def set_net(self, /, **keys: "object") -> None:
        """
        Sets keys of `[net]`: length, m, and start, how it lies at first; None removes a key.
        """
    def set_physics(self, /, **keys: "object") -> None:
        """
        Sets keys of `[physics]`, such as robot_mass, net_mass; None removes a key. NOTATION.md lists all.
        """
    def set_planner(self, /, **keys: "object") -> None:
        """
        Sets keys of `[planner]`, such as max_step, clearance, cruise; None removes a key. NOTATION.md lists all.
        """
    def set_robot(self, /, **keys: "object") -> None:
        """
        Sets keys of `[robot]`, such as radius, hitch, v_max, omega_max, half_track, body, preset; None removes a key.
        """
    def set_start(self, /, left: ArrayLike, right: ArrayLike, heading: SupportsFloat | SupportsIndex | None = None, *, left_heading: SupportsFloat | SupportsIndex | None = None, right_heading: SupportsFloat | SupportsIndex | None = None) -> None:
        """
        Sets where the pair starts: axle centers (x, y), m, and the heading of both, or one for each, rad.
        """
    @property
    def sha256(self, /) -> str:
        """
        SHA-256 of the scene file, then of its map: what plans name the scene by.
        """
    @property
    def start(self, /) -> NDArray[float64]:
        """
        Poses of the left and the right robot at the start, 2 x 3: x and y in m, heading in rad.
        """
    def svg(self, /) -> str:
        """
        The map as SVG, with circles and visiting order, and with the objects marked that provably cannot be gathered.
        """
    def to_dict(self, /) -> dict[str, Any]:
        """
        The scene as a dictionary with the keys of a scene file.
        """
    def to_toml(self, /) -> str:
        """
        The text of the scene file. A scene that was not edited has its file's text, comments and all.
        """
    @property
    def warnings(self, /) -> list[str]:
        """
        What a person should know about the scene.
        """

def _panic(words: str) -> None:
    """
    Panics, so that a test can see what becomes of it.
    """

def _restore_plan(state: bytes) -> Plan:
    """
    A plan of its pickle.
    """

def _restore_scene(state: bytes) -> Scene:
    """
    A scene of its pickle.
    """

def check(scene: Scene, plan: Plan) -> Certificate:
    """
    Derives every claim anew, from the scene and the two trajectories alone.
    """

def generate_hall(size: SupportsLenAndGetItem[SupportsFloat | SupportsIndex], boxes: SupportsIndex, objects: SupportsIndex, near: SupportsFloat | SupportsIndex, seed: SupportsIndex) -> Scene:
    """
    Scatters litter in an open hall.
    """

def generate_litter(map: str | PathLike[str], objects: SupportsIndex, near: SupportsFloat | SupportsIndex, seed: SupportsIndex) -> Scene:
    """
    Scatters litter on the floor of a ROS map.
    """

def generate_solvable(kind: str, difficulty: SupportsIndex, seed: SupportsIndex, waypoints: SupportsIndex) -> Scene:
    """
    Makes a scene that is solvable by construction.
    """

def length_curve(scene: Scene, start: SupportsFloat | SupportsIndex | None, stop: SupportsFloat | SupportsIndex | None, points: SupportsIndex | None, options: dict[str, Any], threads: SupportsIndex | None, progress: Callable[..., object] | None) -> LengthCurve:
    """
    Computes J over the length of the net, with the route fixed. `pairtrawl.length_curve` has the options by keyword.
    """

def plan(scene: Scene, options: dict[str, Any], threads: SupportsIndex | None, progress: Callable[..., object] | None) -> Plan:
    """
    Plans a scene. `pairtrawl.plan` has the options by keyword.
    """

def plan_batch(scenes: SupportsGetItem[int, Scene], options: SupportsGetItem[int, dict[str, Any]], threads: SupportsIndex | None, progress: Callable[..., object] | None) -> list[Plan | PairtrawlError]:
    """
    Plans scenes in parallel, each with its own options. The answers come in order, and each is the same, bit for bit, as if its
    scene was planned alone.
    """

def rehearse(scene: Scene, plan: Plan, *, time_step: SupportsFloat | SupportsIndex | None = None, frame_interval: SupportsFloat | SupportsIndex | None = None) -> Rehearsal:
    """
    Drives the smooth curve of a plan in physics, closely, and says whether the plan is at fault for anything. It is no proof.
    """

def replan(before: Plan, scene: Scene, passed: SupportsIndex, options: dict[str, Any], threads: SupportsIndex | None, progress: Callable[..., object] | None) -> Plan:
    """
    Plans a scene that has changed since `before` was planned, from the waypoint `passed` of it on.
    """

def run(scene: Scene, plan: Plan, options: dict[str, Any], output: str | PathLike[str] | None, threads: SupportsIndex | None, progress: Callable[..., object] | None) -> Execution:
    """
    Lets controllers drive a plan in physics, several trials in parallel. `pairtrawl.run` has the options by keyword.
    """
