"""Joints of the extension CAIRN_joint (docs/scene_format.md), together with the limits and drives of the Khronos draft
that approximate them best."""

import math


def spring(stiffness, damping):
    return {"stiffness": stiffness, "damping": damping}


def control(lower=None, upper=None, velocity=None, position=None, to=None, most=None, friction=None):
    """The control of an axis: a range; a motor with a velocity, or with a position and a spring `to` it; `most`, its
    maximum force; friction."""
    made = {}
    if lower is not None or upper is not None:
        bounds = (("lower", lower), ("upper", upper))
        made["limits"] = {name: round(value, 6) for name, value in bounds if value is not None}
    if velocity is not None or to is not None:
        motor = {}
        if velocity is not None:
            motor["velocity"] = round(velocity, 6)
        if to is not None:
            motor.update({"position": round(position or 0, 6), "spring": to})
        if most is not None:
            motor["max_force"] = most
        made["motor"] = motor
    if friction is not None:
        made["friction"] = friction
    return made


def _lock(kind, *axes):
    return {f"{kind}Axes": list(axes), "min": 0, "max": 0}


def _limits(kind, axis, made):
    limits = made.get("limits")
    if not limits:
        return []
    names = (("lower", "min"), ("upper", "max"))
    return [{f"{kind}Axes": [axis], **{theirs: limits[ours] for ours, theirs in names if ours in limits}}]


def _drives(kind, axis, made):
    motor = made.get("motor", {})
    if "spring" not in motor:
        return []  # the draft has no motors that keep a velocity
    to = motor["spring"]
    drive = {"type": kind, "mode": "acceleration" if to.get("is_acceleration") else "force", "axis": axis}
    if "max_force" in motor:
        drive["maxForce"] = motor["max_force"]
    drive.update({"positionTarget": motor["position"], "stiffness": to["stiffness"],
                  "velocityTarget": motor.get("velocity", 0), "damping": to["damping"]})
    return [drive]


def _entry(kind, limits, drives, members, strength=None, solver=None):
    own = {"type": kind, **members}
    if strength is not None:
        own["break_force"] = strength
    if solver is not None:
        own["solver"] = solver
    made = {name: value for name, value in (("limits", limits), ("drives", drives)) if value}
    return {**made, "extensions": {"CAIRN_joint": own}}


def ball(cone=None, twist=None, friction=None, **how):
    """how, here and below: `strength`, the breaking force, and `solver`. cone: the greatest angle between the x axes,
    degrees. twist: the limit about them in either direction, degrees."""
    limits, members = [_lock("linear", 0, 1, 2)], {}
    if cone is not None:
        members["cone_angle"] = round(math.radians(cone), 6)
        limits.append({"angularAxes": [1, 2], "max": members["cone_angle"]})
    if twist is not None:
        made = control(-math.radians(twist), math.radians(twist))
        members["twist"] = made["limits"]
        limits += _limits("angular", 0, made)
    if friction is not None:
        members["friction"] = friction
    return _entry("ball", limits, [], members, **how)


def hinge(angle=None, **how):
    angle = angle or {}
    limits = [_lock("linear", 0, 1, 2), _lock("angular", 1, 2), *_limits("angular", 0, angle)]
    return _entry("hinge", limits, _drives("angular", 0, angle), {"angle": angle} if angle else {}, **how)


def slider(translation=None, **how):
    translation = translation or {}
    limits = [_lock("linear", 1, 2), _lock("angular", 0, 1, 2), *_limits("linear", 0, translation)]
    return _entry("slider", limits, _drives("linear", 0, translation), {"translation": translation} if translation else {}, **how)


def wheel(suspension, spin, steering=None, **how):
    limits = [_lock("linear", 1, 2), _lock("angular", 2) if steering else _lock("angular", 0, 2),
              *_limits("linear", 0, suspension)]
    drives = _drives("linear", 0, suspension)
    members = {"suspension": suspension, "spin": spin}
    if steering:
        limits += _limits("angular", 0, steering)
        drives += _drives("angular", 0, steering)
        members["steering"] = steering
    return _entry("wheel", limits, drives, members, **how)


def rope(length, **how):
    return _entry("distance", [{"linearAxes": [0, 1, 2], "max": length}], [], {"distance": control(0, length)}, **how)


def gear(ratio):
    return _entry("gear", [], [], {"ratio": ratio})


def pulley(ground_a, ground_b, ratio=1):
    return _entry("pulley", [], [], {"ground_a": list(ground_a), "ground_b": list(ground_b), "ratio": ratio})
