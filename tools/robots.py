#!/usr/bin/env python3
"""Public robots that hold poses and stand, by tables of joint targets at the command line.

usage: tools/robots.py PROGRAM FOLDER [--only PART] [--markdown | --dropped]

FOLDER is a copy of github.com/Gepetto/example-robot-data. Arms are fixed at their base and go to random poses within their
limits; there, the torques of their joints are compared with the closed form: the moment of the weight of all links beyond a
joint about its axis, reckoned here from the URDF file alone. Robots with legs go to the pose in which their SRDF file has
them stand, straighten their joints by a fifth, go back, and stand. With `--dropped`, all robots of the folder fall limp on a floor
instead.

Exit status 1 if a torque is off by more than 1 % of the greatest of its pose, or a robot does not stand, or gains energy.
"""
import argparse
import csv
import io
import math
import pathlib
import random
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

ARMS = ["ur_description/urdf/ur3_robot.urdf", "ur_description/urdf/ur5_robot.urdf", "ur_description/urdf/ur10_robot.urdf",
        "panda_description/urdf/panda.urdf", "kinova_description/robots/kinova.urdf", "z1_description/urdf/z1.urdf",
        "bravo7_description/urdf/bravo7_no_ee.urdf", "talos_data/robots/talos_left_arm.urdf"]
# The robot, the file with its poses, the name of its standing pose, the time to reach it in seconds, and the frequency
# of its servos in Hz: an ankle's servo, which is computed with the mass of the foot alone, carries the whole humanoid.
STANDING = [("a1_description/urdf/a1.urdf", "a1_description/srdf/a1.srdf", "standing", 0, 20),
            ("go1_description/urdf/go1.urdf", "go1_description/srdf/go1.srdf", "standing", 0, 20),
            ("go2_description/urdf/go2.urdf", "go2_description/srdf/go2.srdf", "standing", 0, 20),
            ("b1_description/urdf/b1.urdf", "b1_description/srdf/b1.srdf", "standing", 0, 20),
            ("anymal_b_simple_description/robots/anymal.urdf", "anymal_b_simple_description/srdf/anymal.srdf", "standing", 0, 20),
            ("hyq_description/robots/hyq_no_sensors.urdf", "hyq_description/srdf/hyq.srdf", "standing", 0, 20),
            ("solo_description/robots/solo12.urdf", "solo_description/srdf/solo.srdf", "standing", 0, 20),
            ("talos_data/robots/talos_reduced.urdf", "talos_data/srdf/talos.srdf", "half_sitting", 3, 60)]
POSES = 5
STANDING_SECONDS = 60  # with 14 s, a robot whose oscillation grew was taken to stand
GRAVITY = 9.81
TORQUE_BAR = 0.01  # relative to the greatest torque of a pose
TILT_BAR = 10.0  # degrees
ENERGY_BAR, NOISE = 0.05, 0.05  # relative to the greatest kinetic energy; J
REST_BAR = 0.002  # for all three coordinates in the last second, m
PATIENCE = 300  # s


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def turned(m, v):
    return [dot(row, v) for row in m]


def product(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def about(axis, angle):
    """A rotation about an axis, by Rodrigues' formula."""
    length = math.sqrt(dot(axis, axis))
    x, y, z = (v / length for v in axis)
    c, s = math.cos(angle), math.sin(angle)
    t = 1 - c
    return [[t * x * x + c, t * x * y - s * z, t * x * z + s * y], [t * x * y + s * z, t * y * y + c, t * y * z - s * x],
            [t * x * z - s * y, t * y * z + s * x, t * z * z + c]]


def numbers(element, attribute, default):
    text = element.get(attribute) if element is not None else None
    return [float(word) for word in text.split()] if text else default


def frame(element):
    """(position, rotation) of the `origin` of an element."""
    origin = element.find("origin")
    roll, pitch, yaw = numbers(origin, "rpy", [0.0] * 3)
    turn = product(about([0, 0, 1], yaw), product(about([0, 1, 0], pitch), about([1, 0, 0], roll)))
    return numbers(origin, "xyz", [0.0] * 3), turn


class Robot:
    """The kinematic tree of a URDF file."""

    def __init__(self, path):
        root = ElementTree.parse(path).getroot()
        self.links = {link.get("name"): link for link in root.findall("link")}
        self.joints = [joint for joint in root.findall("joint")]
        self.children = {}
        for joint in self.joints:
            self.children.setdefault(joint.find("parent").get("link"), []).append(joint)
        hanging = {joint.find("child").get("link") for joint in self.joints}
        self.root = next(name for name in self.links if name not in hanging)

    def moving(self, *types):
        return [joint for joint in self.joints if joint.get("type") in types and joint.find("mimic") is None]

    def weight_moments(self, positions):
        """For each hinge: the moment about its axis that balances the weight of all links beyond it. z is up."""
        moments = {}

        def visit(name, place, turn):
            """(mass, mass times position) of a link and all links beyond it."""
            inertial = self.links[name].find("inertial")
            mass, sums = 0.0, [0.0] * 3
            if inertial is not None:
                mass = float(inertial.find("mass").get("value"))
                at = turned(turn, frame(inertial)[0])
                sums = [mass * (place[i] + at[i]) for i in range(3)]
            for joint in self.children.get(name, []):
                offset, rotation = frame(joint)
                there = [place[i] + turned(turn, offset)[i] for i in range(3)]
                way = product(turn, rotation)
                axis, position = numbers(joint.find("axis"), "xyz", [1.0, 0.0, 0.0]), positions.get(joint.get("name"), 0.0)
                beyond, kind = way, joint.get("type")
                if kind in ("revolute", "continuous"):
                    beyond = product(way, about(axis, position))
                seat = there
                if kind == "prismatic":
                    seat = [there[i] + position * turned(way, axis)[i] for i in range(3)]
                part, part_sums = visit(joint.find("child").get("link"), seat, beyond)
                if kind in ("revolute", "continuous"):
                    arm = [part_sums[i] - part * there[i] for i in range(3)]
                    unit = [v / math.sqrt(dot(axis, axis)) for v in axis]
                    moments[joint.get("name")] = dot(cross(arm, [0.0, 0.0, GRAVITY]), turned(way, unit)), turned(way, unit)
                mass += part
                sums = [sums[i] + part_sums[i] for i in range(3)]
            return mass, sums

        visit(self.root, [0.0] * 3, about([0, 0, 1], 0.0))
        return moments


def table_of(rows, names):
    """A table of targets as text; each row is (time, {name: position})."""
    lines = ["time," + ",".join(names)]
    lines += [f"{time}," + ",".join(f"{pose[name]:.6f}" for name in names) for time, pose in rows]
    return "\n".join(lines) + "\n"


def run(program, path, targets, options):
    """The rows of the table that the program prints."""
    command = [program, "run", path.name, "--targets", "/dev/stdin", "--csv", "-", *options]
    done = subprocess.run(command, cwd=path.parent, input=targets, capture_output=True, text=True, timeout=PATIENCE)
    if done.returncode != 0:
        sys.exit(f"{path}: {done.stderr.strip()}")
    return list(csv.DictReader(io.StringIO(done.stdout)))


def hold(program, path):
    """(verdict, observations) of an arm."""
    robot, dice = Robot(path), random.Random(path.name)
    joints = robot.moving("revolute", "continuous", "prismatic")
    worst, greatest, astray = 0.0, 0.0, 0.0
    held = 0
    while held < POSES:
        pose = {}
        for joint in joints:
            limit = joint.find("limit")
            low, high = (float(limit.get(end, 0)) for end in ("lower", "upper")) if limit is not None else (0.0, 0.0)
            low, high = (max(low, -1.5), min(high, 1.5)) if low < high else (-1.5, 1.5)
            pose[joint.get("name")] = dice.uniform(low + 0.1 * (high - low), high - 0.1 * (high - low))
        targets = table_of([(4, pose)], list(pose))
        options = ["--fixed-base", "--seconds", str(STANDING_SECONDS), "--from", "14", "--columns", "joints,contacts"]
        row = run(program, path, targets, options)[-1]
        if row["contacts"] != "0":
            continue  # its links touch each other
        held += 1
        seen = {name: float(row[f"{name}.position"]) for name in pose}
        moments = robot.weight_moments(seen)
        scale = max(abs(moment) for moment, _ in moments.values())
        for name, (moment, axis) in moments.items():
            # The program's y is up: the file's (x, y, z) is its (x, z, -y).
            x, y, z = (float(row[f"{name}.torque_{c}"]) for c in "xyz")
            worst = max(worst, abs(dot([x, -z, y], axis) - moment) / scale)
        greatest = max(greatest, scale)
        astray = max([astray] + [abs(seen[name] - pose[name]) for name in seen])
    what = f"{100 * worst:.2f} % of up to {greatest:.1f} N m, {math.degrees(astray):.2f} degrees from the target"
    return worst <= TORQUE_BAR, what


def stand(program, path, poses, state, seconds, frequency):
    """(verdict, observations) of a legged robot."""
    robot = Robot(path)
    root = ElementTree.parse(poses).getroot()
    joints = {joint.get("name") for joint in robot.moving("revolute", "continuous", "prismatic")}
    pose = dict.fromkeys(joints, 0.0)
    for joint in next(group for group in root.findall("group_state") if group.get("name") == state).findall("joint"):
        if joint.get("name") in joints:
            pose[joint.get("name")] = float(joint.get("value"))
    straighter = {name: 0.8 * value for name, value in pose.items()}
    first = pose if seconds == 0 else dict.fromkeys(joints, 0.0)
    targets = table_of([(0, first), (seconds + 0.1, pose), (5, pose), (7, straighter), (9, pose)], sorted(joints))
    options = ["--floor", "--seconds", "14", "--columns", "position,rotation", "--every", "10", "--servo-frequency",
               str(frequency)]
    rows = [row for row in run(program, path, targets, options) if row["body"] == "0"]
    heights, tilts = [], []
    for row in rows:
        qx, qy, qz, qw = (float(row[f"q{c}"]) for c in "xyzw")
        # The tilt of the file's z axis from the program's y axis, with which it coincides at the start.
        up = [2 * (qx * qz + qw * qy), 2 * (qy * qz - qw * qx), 1 - 2 * (qx * qx + qy * qy)]
        tilts.append(math.degrees(math.acos(max(-1.0, min(1.0, up[1])))))
        heights.append(float(row["py"]))
    sunk = heights[0] - heights[-1]
    moved = math.hypot(float(rows[-1]["px"]) - float(rows[0]["px"]), float(rows[-1]["pz"]) - float(rows[0]["pz"]))
    last_second = [[float(row[axis]) for row in rows[-6:]] for axis in ("px", "py", "pz")]
    sways = max(max(places) - min(places) for places in last_second)
    what = (f"leans by {tilts[-1]:.1f} degrees, on the way {max(tilts):.1f}; {1000 * sunk:.0f} mm lower and "
            f"{1000 * moved:.0f} mm beside where it was drawn, sways by {1000 * sways:.1f} mm")
    return max(tilts) < TILT_BAR and sways < REST_BAR, what


def drop(program, path):
    """(whether it passed, observations) of a robot that falls on a floor without drives."""
    command = [program, "run", path.name, "--floor", "--seconds", "5", "--columns", "energy", "--csv", "-"]
    done = subprocess.run(command, cwd=path.parent, capture_output=True, text=True, timeout=PATIENCE)
    if done.returncode != 0:
        reason = done.stderr.strip().splitlines()[-1].split(": ", 2)[-1]
        return True, f"refused: {reason}"
    rows = [(float(row["kinetic"]), float(row["potential"])) for row in csv.DictReader(io.StringIO(done.stdout))]
    gained = max(kinetic + potential for kinetic, potential in rows) - sum(rows[0])
    greatest = max(kinetic for kinetic, _ in rows)
    # In free fall: links without shapes fall through the floor.
    falls = rows[-1][0] > 0.9 * (rows[0][1] - rows[-1][1]) and rows[-1][0] > 10
    seen = f"{greatest:.1f} J at most, {rows[-1][0]:.2f} J at the end, gained {max(gained, 0.0):.2f} J"
    is_good = gained <= ENERGY_BAR * greatest + NOISE
    return is_good, f"{'falls through' if falls else 'lies' if is_good else 'gains'}: {seen}"


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("usage: ")[1].split("\n")[0])
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--only", default="")
    parser.add_argument("--dropped", action="store_true")
    parser.add_argument("--markdown", action="store_true", help="as the table of docs/models.md")
    options = parser.parse_args()
    program, robots = str(pathlib.Path(options.program).resolve()), options.folder.resolve() / "robots"
    trials = [(arm, "holds poses", lambda arm=arm: hold(program, robots / arm)) for arm in ARMS]
    trials += [(robot, "stands", lambda robot=robot, poses=poses, rest=rest: stand(program, robots / robot, robots / poses,
                                                                                  *rest))
               for robot, poses, *rest in STANDING]
    if options.dropped:
        paths = sorted(path for path in robots.rglob("*.urdf"))
        trials = [(str(path.relative_to(robots)), "dropped", lambda path=path: drop(program, path)) for path in paths]
    bad = 0
    if options.markdown:
        print("| robot | | |\n|---|---|---|")
    for robot, task, trial in trials:
        if options.only not in robot:
            continue
        is_good, what = trial()
        bad += not is_good
        verdict = task if is_good else "does not: " + task
        print(f"| {pathlib.Path(robot).stem} | {verdict} | {what} |" if options.markdown else f"{robot}: {verdict}: {what}",
              flush=True)
    return bad > 0


if __name__ == "__main__":
    sys.exit(main())
