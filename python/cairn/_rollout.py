"""Many worlds from one."""
from __future__ import annotations

from typing import Any, Mapping, Sequence

import numpy as np

from ._cairn import Body, BodyId, JointId, ShapeId, World, _rollout, hardware_threads


def rollout(world: World, parameters: Mapping[Any, Any] | None = None, steps: int = 1, *,
            record: Sequence[str] = ("positions",), worlds: int | None = None, every: int = 1, dt: float | None = None,
            threads: int | None = None) -> dict[str, np.ndarray]:
    """Runs many copies of a world side by side, each with parameters of its own, and records what they do. The world itself
    stays as it is. Results depend neither on the number of threads nor on the other worlds.

    `parameters`: by name, or by (body, shape or joint, name), an array with a value for each world, or for each step of each
    world: worlds x steps (x 3).
    Of the world: gravity, substeps, restitution_speed, recovery_speed. Of a body: position, rotation (x, y, z, w),
    linear_velocity, angular_velocity, mass, gravity_scale, linear_damping, angular_damping, and force and torque, which act
    in one step: of arrays without steps, in the first. Of a shape: friction, static_friction, dynamic_friction, restitution,
    rolling_friction, torsional_friction. Of a joint with one axis (hinge, slider, distance): motor_velocity, motor_position,
    motor_max_force.
    `record`: positions, rotations, velocities, angular_velocities (worlds x frames x bodies x 3 or 4), kinetic_energy,
    potential_energy, state_hash (worlds x frames). A frame is taken after every `every` steps.
    `worlds`: how many; None: as many as the parameters have values for. `dt`: s; None: `world.time_step`. `threads`: 1 to 256;
    None: as many as this machine has.

    Raises the error of the first world that has one, InvalidValueError for unknown names, ValueError for wrong shapes."""
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
        raise ValueError("worlds: must be given where there are no parameters")
    if isinstance(record, str):
        record = [record]
    for name, value in (("worlds", worlds), ("steps", steps), ("every", every)):
        if value < 0:
            raise ValueError(f"{name}: must not be negative, got {value}")
    return _rollout(world, entries, worlds, steps, world.time_step if dt is None else dt, list(record), every,
                    hardware_threads() if threads is None else threads)
