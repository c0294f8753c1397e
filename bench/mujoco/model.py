"""Drives an exported model in MuJoCo with the same tracking law that the rehearsal uses."""

import math
import time

import mujoco
import numpy as np

ALONG, ACROSS, TURN = 10.0, 400.0, 10.0
# Forces count from here until the plan's end, s.
START = 1.0


class Run:
    """What a run in MuJoCo showed."""

    def __init__(self, net, objects, drive_force, factor, gap):
        self.net = net
        self.objects = objects
        self.drive_force = drive_force
        self.factor = factor
        self.gap = gap


def reference(poses, step_time, when):
    steps = when / step_time
    i = min(int(steps), len(poses) - 2)
    part = min(steps - i, 1.0)
    a, b = poses[i], poses[i + 1]
    pose = a + (b - a) * part
    if steps >= len(poses) - 1:
        return pose, 0.0, 0.0
    middle = 0.5 * (a[2] + b[2])
    forward = ((b[0] - a[0]) * math.cos(middle) + (b[1] - a[1]) * math.sin(middle)) / step_time
    return pose, forward, (b[2] - a[2]) / step_time


def command(state, pose, forward, rate):
    """Speed and turning rate that lead back to the reference (as in crates/execution/src/rehearsal.rs)."""
    x, y, heading = state
    dx, dy = pose[0] - x, pose[1] - y
    ahead = dx * math.cos(heading) + dy * math.sin(heading)
    aside = -dx * math.sin(heading) + dy * math.cos(heading)
    error = pose[2] - heading
    return forward * math.cos(error) + ALONG * ahead, rate + ACROSS * forward * aside + TURN * math.sin(error)


def run(xml, settle_time=0.5):
    """Loads a model, puts it into its keyframe and drives the plan in its custom numbers."""
    model = mujoco.MjModel.from_xml_string(xml)
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, model.key("start").id)

    def numbers(name):
        numeric = model.numeric(name)
        return np.array(numeric.data)

    step_time = float(numbers("plan_step_time")[0])
    plans = [numbers(f"plan_{side}").reshape(-1, 3) for side in ("left", "right")]
    duration = step_time * (len(plans[0]) - 1) + settle_time
    places = [[model.joint(f"{side}_{axis}").qposadr[0] for axis in ("x", "y", "heading")] for side in ("left", "right")]
    motors = [[model.actuator(f"{side}_{axis}").id for axis in ("x", "y", "heading")] for side in ("left", "right")]
    force, counted = np.zeros(2), 0
    steps = math.ceil(duration / model.opt.timestep)
    gap = 0.0
    started = time.perf_counter()
    for _ in range(steps):
        when = data.time + model.opt.timestep
        headings = []
        for side in range(2):
            state = data.qpos[places[side]]
            v, w = command(state, *reference(plans[side], step_time, when))
            heading = state[2]
            headings.append(heading)
            middle = heading + 0.5 * w * model.opt.timestep
            data.ctrl[motors[side]] = (v * math.cos(middle), v * math.sin(middle), w)
        mujoco.mj_step(model, data)
        # While robots set off and stop, the actuators' explicit force is not what their implicit integration applies.
        if not START < when < duration - settle_time - START:
            continue
        counted += 1
        for side in range(2):
            f = data.actuator_force[motors[side]]
            force[side] += f[0] * math.cos(headings[side]) + f[1] * math.sin(headings[side])
    seconds = time.perf_counter() - started
    mujoco.mj_forward(model, data)
    gap = float(np.linalg.norm(data.site("net_end").xpos[:2] - data.site("right_ring").xpos[:2]))
    links = sorted((int(model.body(i).name[5:]), i) for i in range(model.nbody) if model.body(i).name.startswith("link_"))
    net = [data.xpos[i][:2].copy() for _, i in links] + [data.site("net_end").xpos[:2].copy()]
    count = sum(model.body(i).name.startswith("object_") for i in range(model.nbody))
    objects = [data.body(f"object_{i}").xpos[:2].copy() for i in range(count)]
    return Run(net, objects, force / counted, duration / seconds, gap)


def encloses(net, place):
    """The winding number of the net, closed by the hitch line, around a place is not zero."""
    winding = 0
    for i in range(len(net)):
        a, b = net[i], net[(i + 1) % len(net)]
        side = (b[0] - a[0]) * (place[1] - a[1]) - (b[1] - a[1]) * (place[0] - a[0])
        if a[1] <= place[1] < b[1] and side > 0:
            winding += 1
        elif b[1] <= place[1] < a[1] and side < 0:
            winding -= 1
    return winding != 0
