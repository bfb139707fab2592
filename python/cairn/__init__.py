"""Cairn, a 3D rigid-body physics engine with the same bits on every machine.

    import cairn

    world = cairn.World()
    ground = world.create_body(type="static")
    world.add_shape(ground, cairn.Plane())
    crate = world.create_body(position=(0, 5, 0))
    world.add_shape(crate, cairn.Box((0.5, 0.5, 0.5)), density=600)
    world.step(n=600)
    print(world.body(crate).position)

Lengths are in meters, masses in kilograms, angles in radians; y is up. A call with an invalid argument raises a
`cairn.Error`, and leaves the world unchanged.
"""
from ._arrays import BodyArray
from ._cairn import (Body, BodyId, ForceFieldId, HeightField, Hull, JointId, Mesh, ShapeId, Snapshot, World, __version__,
                     find_scene, hardware_threads, instruction_set, load, save)
from ._errors import (Error, FileError, InvalidFileError, InvalidHandleError, InvalidValueError, UnsupportedError,
                      WrongStateError)
from ._rollout import rollout
from ._types import *
from ._types import __all__ as _types
from ._view import picture, video, view

__all__ = ["Body", "BodyArray", "BodyId", "Error", "FileError", "ForceFieldId", "HeightField", "Hull", "InvalidFileError",
           "InvalidHandleError", "InvalidValueError", "JointId", "Mesh", "ShapeId", "Snapshot", "UnsupportedError", "World",
           "WrongStateError", "find_scene", "hardware_threads", "instruction_set", "load", "picture", "rollout", "save",
           "video", "view", *_types]
