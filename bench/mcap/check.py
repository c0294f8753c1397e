"""Reads a recording back with two independent readers: PyPI rosbags (the folder as a rosbag2) and mcap-ros2-support.

python3 bench/mcap/check.py FOLDER    FOLDER holds run.mcap and metadata.yaml, and execution.json of the same run
Needs: pip install rosbags mcap-ros2-support
"""

import json
import math
import pathlib
import sys

from mcap.reader import make_reader
from mcap_ros2.decoder import DecoderFactory
from rosbags.rosbag2 import Reader
from rosbags.typesys import Stores, get_typestore

TOPICS = {
    "/left/plan": "nav_msgs/msg/Path",
    "/right/plan": "nav_msgs/msg/Path",
    "/left/odom": "nav_msgs/msg/Odometry",
    "/right/odom": "nav_msgs/msg/Odometry",
    "/left/torque": "std_msgs/msg/Float64MultiArray",
    "/right/torque": "std_msgs/msg/Float64MultiArray",
    "/tf": "tf2_msgs/msg/TFMessage",
    "/map": "nav_msgs/msg/OccupancyGrid",
    "/markers": "visualization_msgs/msg/MarkerArray",
}


def check(condition, words):
    if not condition:
        sys.exit(f"the recording is wrong: {words}")


def yaw(q):
    return 2.0 * math.atan2(q.z, q.w)


def read_with_rosbags(folder):
    store = get_typestore(Stores.ROS2_HUMBLE)
    found = {}
    with Reader(folder) as reader:
        check({c.topic: c.msgtype for c in reader.connections} == TOPICS, "topics or types differ")
        check(reader.message_count == sum(c.msgcount for c in reader.connections), "message counts differ")
        for connection, _, data in reader.messages():
            found.setdefault(connection.topic, []).append(store.deserialize_cdr(data, connection.msgtype))
        check(len(found["/left/odom"]) == next(c.msgcount for c in reader.connections if c.topic == "/left/odom"),
              "metadata.yaml counts other messages")
    return found


def read_with_mcap(path):
    found = {}
    with open(path, "rb") as file:
        reader = make_reader(file, decoder_factories=[DecoderFactory()])
        check(reader.get_header().profile == "ros2", "profile is not ros2")
        summary = reader.get_summary()
        check(summary.chunk_indexes, "no chunk indexes")
        for channel in summary.channels.values():
            check(channel.message_encoding == "cdr", f"{channel.topic} is not in CDR")
            check("offered_qos_profiles" in channel.metadata, f"{channel.topic} has no offered_qos_profiles")
        for _, channel, _, message in reader.iter_decoded_messages():
            found.setdefault(channel.topic, []).append(message)
    return found


def main():
    folder = pathlib.Path(sys.argv[1])
    first, second = read_with_rosbags(folder), read_with_mcap(folder / "run.mcap")
    check({t: len(m) for t, m in first.items()} == {t: len(m) for t, m in second.items()}, "the readers disagree")
    for topic in ("/left/odom", "/right/odom"):
        for a, b in zip(first[topic], second[topic]):
            p, q = a.pose.pose, b.pose.pose
            check((p.position.x, p.position.y) == (q.position.x, q.position.y), f"positions of {topic} differ")
            check(abs(math.hypot(q.orientation.z, q.orientation.w) - 1.0) < 1e-12, "a quaternion is not one")
            check(a.twist.twist.linear.x == b.twist.twist.linear.x, f"speeds of {topic} differ")
            check(len(a.pose.covariance) == 36 and len(b.twist.covariance) == 36, "a covariance has not 36 entries")
    grid = second["/map"][0]
    check(grid.info.width * grid.info.height == len(grid.data), "the grid has not as many cells as it says")
    check(set(grid.data) <= {0, 100}, "a cell is neither free nor obstacle")
    end = json.loads((folder / "execution.json").read_text())["trials"][0]["final"]
    for side in ("left", "right"):
        pose = second[f"/{side}/odom"][-1].pose.pose
        gap = math.hypot(pose.position.x - end[side][0], pose.position.y - end[side][1])
        check(gap < 0.02, f"{side} robot ends {gap} m from execution.json")
        turn = math.remainder(yaw(pose.orientation) - end[side][2], 2.0 * math.pi)
        check(abs(turn) < 0.05, f"{side} robot ends turned by {turn} rad against execution.json")
    markers = second["/markers"][-1].markers
    check(len(markers) == 1 + len(end["objects"]), "markers are not the net and all objects")
    check(len(markers[0].points) == len(end["net"]), "the net has other points than in execution.json")
    for marker, place in zip(markers[1:], end["objects"]):
        gap = math.hypot(marker.pose.position.x - place[0], marker.pose.position.y - place[1])
        check(gap < 1e-9, f"object {marker.id} lies {gap} m off")
    frames = {t.child_frame_id for m in second["/tf"] for t in m.transforms}
    check(frames == {"left/odom", "left/base_link", "right/odom", "right/base_link"}, f"frames are {frames}")
    total = sum(map(len, second.values()))
    print(f"both readers agree on {total} messages of {len(TOPICS)} topics")


if __name__ == "__main__":
    main()
