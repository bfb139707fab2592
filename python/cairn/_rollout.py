"""Simulates many copies of a world with different parameters."""
from __future__ import annotations

from typing import Any, Mapping, Sequence

import numpy as np

from ._cairn import Body, BodyId, JointId, ShapeId, World, _rollout, hardware_threads


def rollout(world: World, parameters: Mapping[Any, Any] | None = None, steps: int = 1, *,
            record: Sequence[str] = ("positions",), worlds: int | None = None, every: int = 1, dt: float | None = None,
            threads: int | None = None) -> dict[str, np.ndarray]:
    """Simulates many copies of a world in parallel, each with its own parameters, and records their states. The world itself
    does not change. Results depend neither on the number of threads nor on the other worlds.

    `parameters`: arrays of values; the key is a name, or a tuple of a body, shape or joint and a name. An array has a value
    for each world (worlds, or worlds x 3 or 4), or for each step of each world (worlds x steps, or worlds x steps x 3 or 4).
    Names for the world: gravity, substeps, restitution_speed, recovery_speed; for a body: position, rotation (x, y, z, w),
    linear_velocity, angular_velocity, mass, gravity_scale, linear_damping, angular_damping, and force and torque, which act
    during one step (the first, if the array has no values for each step); for a shape: friction, static_friction,
    dynamic_friction, restitution, rolling_friction, torsional_friction; for a joint with one axis (hinge, slider, distance):
    motor_velocity, motor_position, motor_max_force.
    `record`: positions, rotations, velocities, angular_velocities (worlds x frames x bodies x 3 or 4), kinetic_energy,
    potential_energy, state_hash (worlds x frames). A frame is recorded after every `every` steps.
    `worlds`: number of worlds; None: the length of the parameter arrays. `dt`: time step, s; None: `world.time_step`.
    `threads`: 1 to 256; None: the number of hardware threads.

    Raises the error of the first world that fails, InvalidValueError for unknown names, ValueError for arrays of a wrong
    shape."""
    entries = []
    for key, values in (parameters or {}).items():
        target, name = key if isinstance(key, tuple) else (None, key)
        if target is not None and not isinstance(target, (Body, BodyId, ShapeId, JointId)):
            raise TypeError(f"parameter {name}: must be of a body, shape or joint, got {type(target).__name__}")
        array = np.asarray(values, dtype=np.float64)
        if array.ndim == 0:
            raise ValueError(f"parameter {name}: must have a value for each world, got a single number")
        if worlds is None:
            worlds = len(array)
        entries.append((target, str(name), array))
    if worlds is None:
        raise ValueError("worlds: must be given if there are no parameters")
    if isinstance(record, str):
        record = [record]
    for name, value in (("worlds", worlds), ("steps", steps), ("every", every)):
        if value < 0:
            raise ValueError(f"{name}: must not be negative, got {value}")
    return _rollout(world, entries, worlds, steps, world.time_step if dt is None else dt, list(record), every,
                    hardware_threads() if threads is None else threads)
