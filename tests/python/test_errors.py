"""Invalid arguments: the call raises an exception that names the argument, and leaves the world unchanged."""
import math
import os
import pickle
import unittest

import numpy as np

import cairn


class Refusals(unittest.TestCase):
    def setUp(self):
        self.world = cairn.World()
        self.body = self.world.create_body(position=(0, 3, 0))
        self.shape = self.world.add_shape(self.body, cairn.Sphere(0.5))
        self.stale = self.world.create_body()
        self.world.destroy_body(self.stale)
        self.world.step()

    def state(self):
        w = self.world
        return (w.state_hash, w.bodies, w.joints, w.body(self.body).shapes, w.step_count, str(w.settings),
                str(w.shape_def(self.shape)), str(w.body(self.body).mass_properties))

    def expect(self, kind, call, *parts):
        before = self.state()
        with self.assertRaises(kind) as caught:
            call()
        for part in parts:
            self.assertIn(part, str(caught.exception))
        self.assertEqual(self.state(), before)
        return caught.exception

    def test_numbers_that_are_none(self):
        world, body = self.world, self.world.body(self.body)
        for bad in (math.nan, math.inf, -math.inf):
            self.expect(cairn.InvalidValueError, lambda: world.step(bad), "dt")
            self.expect(cairn.InvalidValueError, lambda: world.create_body(position=(0, bad, 0)), "BodyDef.position")
            self.expect(cairn.InvalidValueError, lambda: setattr(body, "linear_velocity", (bad, 0, 0)))
            self.expect(cairn.InvalidValueError, lambda: body.apply_impulse((0, 0, bad)))
            self.expect(cairn.InvalidValueError, lambda: world.cast_ray((0, 0, bad), (0, 1, 0), 1))
            self.expect(cairn.InvalidValueError, lambda: world.add_shape(body, cairn.Sphere(bad)), "Sphere.radius")
            self.expect(cairn.InvalidValueError, lambda: cairn.Hull([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, bad]]))
            self.expect(cairn.InvalidValueError, lambda: setattr(world, "time_step", bad))

    def test_errors_have_field_and_value(self):
        error = self.expect(cairn.InvalidValueError, lambda: self.world.create_body(mass=-2.5), "BodyDef.mass", "-2.5")
        self.assertEqual((error.field, error.value), ("BodyDef.mass", "-2.5"))
        self.assertIsInstance(error, (cairn.Error, ValueError))
        again = pickle.loads(pickle.dumps(error))
        self.assertEqual((str(again), again.field, again.value), (str(error), error.field, error.value))

    def test_errors_are_in_the_words_of_python(self):
        world, body, bad = self.world, self.world.body(self.body), (math.nan, 0, 0)
        for name in ("position", "rotation", "linear_velocity", "angular_velocity", "gravity_scale"):
            value = math.nan if name == "gravity_scale" else (*bad, 1) if name == "rotation" else bad
            error = self.expect(cairn.InvalidValueError, lambda: setattr(body, name, value))
            self.assertTrue(str(error).startswith(f"Body.{name}: must be "), str(error))
            self.assertEqual(error.field, f"Body.{name}")
        for call, words in ((lambda: body.set_damping(-1, 0), "Body.set_damping linear: "),
                            (lambda: body.apply_impulse(bad), "Body.apply_impulse impulse: "),
                            (lambda: world.cast_ray(bad, (0, 1, 0), 1), "World.cast_ray origin: ")):
            error = self.expect(cairn.Error, call)
            self.assertTrue(str(error).startswith(words), str(error))
            self.assertNotIn("::", str(error) + error.field)

    def test_unknown_keywords_list_the_members_that_there_are(self):
        world = self.world
        of_bodies = "BodyDef: has no member 'masss'; it has type, position, "
        for call, words in ((lambda: world.create_body(masss=3), of_bodies), (lambda: cairn.BodyDef(masss=3), of_bodies),
                            (lambda: cairn.Box(half=(1, 1, 1)), "Box: has no member 'half'; it has half_extents"),
                            (lambda: cairn.World(gravty=(0, 0, 0)), "WorldDef: has no member 'gravty'; it has gravity"),
                            (lambda: world.add_shape(self.body, cairn.Sphere(), densty=3), "ShapeDef: has no member ")):
            error = self.expect(TypeError, call)
            self.assertTrue(str(error).startswith(words), str(error))
        self.expect(TypeError, lambda: cairn.Sphere(1, radius=2), "multiple values")
        self.expect(TypeError, lambda: cairn.Sphere(1, 2, 3, 4))

    def test_handles_that_are_stale_null_or_foreign(self):
        other = cairn.World()
        foreign = other.create_body()
        for bad in (self.stale, cairn.BodyId(), foreign, cairn.BodyId(2**64 - 1)):
            self.expect(cairn.InvalidHandleError, lambda: self.world.body(bad))
            self.expect(cairn.InvalidHandleError, lambda: self.world.destroy_body(bad))
            self.expect(cairn.InvalidHandleError, lambda: self.world.add_shape(bad, cairn.Sphere()))
            self.assertFalse(self.world.is_valid(bad))
        self.expect(cairn.InvalidHandleError, lambda: self.world.remove_shape(cairn.ShapeId()))
        self.expect(cairn.InvalidHandleError, lambda: self.world.joint_state(cairn.JointId(77)))
        gone = self.world.create_body()
        accessor = self.world.body(gone)
        self.world.destroy_body(gone)
        self.expect(cairn.InvalidHandleError, lambda: accessor.position)
        self.expect(cairn.InvalidHandleError, lambda: setattr(accessor, "position", (0, 0, 0)))

    def test_wrong_shapes_of_arrays(self):
        body = self.world.body(self.body)
        for bad in ((1, 2), (1, 2, 3, 4), np.zeros(4), np.zeros((1, 3)), np.zeros((3, 1)), np.float64(3)):
            self.expect((ValueError, TypeError), lambda: setattr(body, "position", bad), "Body.position")
        self.expect(ValueError, lambda: setattr(body, "rotation", (1, 0, 0)), "must be 4 long, got 3")
        self.expect(ValueError, lambda: cairn.Hull(np.zeros((5, 2))), "(n, 3)", "(5, 2)")
        self.expect(ValueError, lambda: cairn.Mesh(np.zeros((3, 3)), [0, 1, 2]))
        self.expect(cairn.InvalidValueError, lambda: cairn.Mesh(np.eye(3), [[0, 1, 3]]))
        self.expect(cairn.InvalidValueError, lambda: cairn.Mesh(np.eye(3), [[0, 1, -1]]))
        self.expect(cairn.InvalidValueError, lambda: cairn.Mesh(np.eye(3), [[0, 1, 2**32 + 2]]))
        self.expect(ValueError, lambda: cairn.HeightField(np.zeros(5), (1, 1)))
        self.expect(cairn.InvalidValueError, lambda: cairn.HeightField(np.zeros((1, 5)), (1, 1)))

    def test_wrong_types_say_where(self):
        world = self.world
        self.expect(TypeError, lambda: world.create_body(mass="heavy"), "BodyDef.mass: must be a number, got str")
        self.expect(TypeError, lambda: world.create_body(masss=3), "masss")
        self.expect(TypeError, lambda: world.create_body(cairn.BodyDef(), mass=3), "not both")
        self.expect(TypeError, lambda: world.create_body(cairn.ShapeDef()), "must be a BodyDef")
        self.expect(TypeError, lambda: world.add_shape(self.body, "ball"), "shape: must be a Shape, got str")
        self.expect(TypeError, lambda: world.add_shape(self.shape, cairn.Sphere()), "body: must be a BodyId or Body")
        self.expect(TypeError, lambda: world.cast_ray("abc", (0, 1, 0), 1), "origin")
        self.expect(ValueError, lambda: world.create_body(type="rigid"), "static, kinematic, dynamic", "rigid")
        self.expect(TypeError, lambda: world.create_body(type=2), "BodyDef.type")
        self.expect(ValueError, lambda: world.create_body(user_data=-1), "BodyDef.user_data")
        self.expect(ValueError, lambda: world.create_body(user_data=2**64), "BodyDef.user_data")
        self.expect(TypeError, lambda: world.is_valid(7))
        self.expect((TypeError, ValueError), lambda: world.step(n=-1))
        with self.assertRaises(AttributeError):
            cairn.BodyDef().masss = 3
        with self.assertRaises(AttributeError):
            world.body(self.body).positon = (0, 0, 0)

    def test_code_that_closes_the_world_while_it_is_asked_for_a_value(self):
        world = self.world

        class Trap:
            def __len__(self):
                return 3

            def __getitem__(self, i):
                world.close()
                if i > 2:
                    raise IndexError
                return 0.0

        with self.assertRaises(cairn.WrongStateError):
            world.create_body(position=Trap())
        self.assertTrue(world.closed)

    def test_a_closed_world(self):
        body = self.world.body(self.body)
        self.world.close()
        self.world.close()
        for call in (self.world.step, lambda: self.world.bodies, lambda: body.position, lambda: self.world.positions,
                     self.world.save, lambda: self.world.create_body(), lambda: self.world.is_valid(self.body),
                     lambda: cairn.save(self.world, os.devnull), lambda: self.world.time_step,
                     lambda: cairn.rollout(self.world, worlds=1)):
            with self.assertRaises(cairn.WrongStateError) as caught:
                call()
            self.assertIn("closed", str(caught.exception))
        with cairn.World() as inner:
            inner.create_body()
        self.assertTrue(inner.closed)

    def test_files(self):
        error = self.expect(cairn.FileError, lambda: cairn.load("/nowhere/a.gltf"), "/nowhere/a.gltf")
        self.assertIsInstance(error, OSError)
        self.expect(cairn.FileError, lambda: cairn.save(self.world, "/nowhere/a.gltf"))
        self.expect(cairn.InvalidFileError, lambda: cairn.load(__file__))
        self.expect(TypeError, lambda: cairn.load(5))
        self.expect(cairn.FileError, lambda: cairn.find_scene("no such scene"))


if __name__ == "__main__":
    unittest.main()
