"""Worlds in Python: the behavior of the API, and the same bits as with the C API."""
import ctypes
import os
import pathlib
import pickle
import tempfile
import threading
import time
import unittest

import numpy as np

import cairn

SCENES = pathlib.Path(os.environ["CAIRN_TEST_SCENES"])


def crate(**world):
    """A world with ground and a crate above it."""
    made = cairn.World(**world)
    ground = made.create_body(type="static")
    made.add_shape(ground, cairn.Plane())
    box = made.create_body(position=(0, 5, 0))
    made.add_shape(box, cairn.Box((0.5, 0.5, 0.5)), density=600)
    return made, ground, box


class Steps(unittest.TestCase):
    def test_a_crate_comes_to_rest_on_the_ground(self):
        world, _, box = crate()
        world.step(n=600)
        self.assertAlmostEqual(world.body(box).position[1], 0.5, delta=0.005)
        self.assertAlmostEqual(world.body(box).mass, 600, delta=0.01)
        self.assertFalse(world.body(box).is_awake)
        self.assertAlmostEqual(world.time, 10, places=4)

    def test_every_scene_has_the_hash_that_it_has_in_c(self):
        library = ctypes.CDLL(os.environ["CAIRN_C_LIBRARY"])
        library.cairn_world_steps.argtypes = [ctypes.c_void_p, ctypes.c_float, ctypes.c_size_t]
        for file in sorted(SCENES.glob("*.gltf")):
            with self.subTest(file.stem):
                pointer, dt, value = ctypes.c_void_p(), ctypes.c_float(), ctypes.c_uint64()
                self.assertEqual(library.cairn_scene_load(bytes(file), ctypes.byref(pointer), ctypes.byref(dt)), 0)
                self.assertEqual(library.cairn_world_steps(pointer, dt, 60), 0)
                self.assertEqual(library.cairn_world_get_state_hash(pointer, ctypes.byref(value)), 0)
                library.cairn_world_destroy(pointer)
                world = cairn.load(file)
                world.step(n=60)
                self.assertEqual(world.state_hash, value.value)
                self.assertTrue(world.title)

    def test_many_steps_in_one_call_are_the_same_as_one_by_one(self):
        one, _, _ = crate()
        many, _, _ = crate()
        for _ in range(90):
            one.step()
        many.step(n=90)
        self.assertEqual(one.state_hash, many.state_hash)
        self.assertEqual(many.step_count, 90)
        many.step(n=0)
        self.assertEqual(many.step_count, 90)

    def test_a_character_walks_climbs_and_jumps(self):
        world = cairn.World()
        world.add_shape(world.create_body(type="static"), cairn.Plane())
        step = world.create_body(type="static", position=(3, 0.1, 0))
        world.add_shape(step, cairn.Box((1, 0.1, 1)))
        figure = world.create_body(type="kinematic", position=(0, 0.82, 0))
        world.add_shape(figure, cairn.Capsule(0.5, 0.3))
        body = world.body(figure)
        self.assertFalse(body.is_character)
        body.character = cairn.CharacterDef(step_height=0.25)
        self.assertAlmostEqual(body.character.step_height, 0.25)
        body.walk_velocity = (2, 0, 0)
        world.step(n=90)
        self.assertAlmostEqual(body.position[0], 3, delta=0.05)
        self.assertAlmostEqual(body.position[1], 1.02, delta=0.002)
        state = body.character_state
        self.assertEqual(state.support, cairn.CharacterSupport.ground)
        self.assertEqual(state.ground_body, step)
        body.jump(3)
        world.step(n=10)
        self.assertEqual(body.character_state.support, cairn.CharacterSupport.none)
        self.assertGreater(body.position[1], 1.3)
        with self.assertRaises(cairn.InvalidValueError):
            body.character = cairn.CharacterDef(skin=-1)
        body.remove_character()
        self.assertFalse(body.is_character)

    def test_queries_heed_their_filters(self):
        world, ground, box = crate()
        down = ((0, 9, 0), (0, -1, 0), 20)
        self.assertEqual(world.cast_ray(*down).body, box)
        self.assertEqual(world.cast_ray(*down, dynamic_bodies=False).body, ground)
        self.assertEqual(world.cast_ray(*down, cairn.QueryFilter(ignored_bodies=[box])).body, ground)
        self.assertIsNone(world.cast_ray(*down, layers=2))
        self.assertEqual(len(world.cast_ray_all(*down, any=True)), 1)
        with self.assertRaises(cairn.InvalidHandleError):
            world.cast_ray(*down, ignored_bodies=[cairn.BodyId()])

    def test_other_threads_of_python_run_during_a_step_and_are_kept_from_its_world(self):
        world = cairn.load(SCENES / "13_pile.gltf")
        counted, refused, done = 0, [], threading.Event()

        def run():
            world.step(n=120)
            done.set()

        thread = threading.Thread(target=run)
        thread.start()
        while not done.is_set():
            counted += 1
            for call in (lambda: world.kinetic_energy, lambda: world.positions, lambda: world.create_body(),
                         lambda: world.step(), world.close, world.save):
                try:
                    call()
                except cairn.WrongStateError as error:
                    refused.append(str(error))
                except cairn.Error as error:  # pragma: no cover
                    self.fail(f"another error: {error}")
                if done.is_set():
                    break
            time.sleep(0.001)
            if counted > 3 and len(refused) > 20:
                break
        thread.join()
        self.assertGreater(len(refused), 6)
        self.assertIn("the world is in World.step on another thread", refused[0])

    def test_a_world_goes_back_to_its_snapshot(self):
        world, _, box = crate()
        world.step(n=30)
        snapshot = world.save()
        world.step(n=50)
        expected = world.state_hash
        gone = world.create_body()
        world.restore(snapshot)
        self.assertFalse(world.is_valid(gone))
        self.assertTrue(world.is_valid(box))
        world.step(n=50)
        self.assertEqual(world.state_hash, expected)
        self.assertGreater(snapshot.nbytes, 100)

    def test_a_saved_scene_is_loaded_again(self):
        world, _, box = crate()
        world.body(box).name = "crate"
        world.title, world.hint, world.time_step = "A crate", "falls", 1 / 120
        with tempfile.TemporaryDirectory() as folder:
            for name in ("a.gltf", "a.glb"):
                cairn.save(world, pathlib.Path(folder) / name)
                again = cairn.load(os.path.join(folder, name))
                self.assertEqual((again.title, again.hint), ("A crate", "falls"))
                self.assertAlmostEqual(again.time_step, 1 / 120, places=7)
                np.testing.assert_allclose(again.body(again.find_body("crate")).position, (0, 5, 0))


class Members(unittest.TestCase):
    def test_setting_what_can_be_read_reads_back(self):
        world, _, box = crate()
        body = world.body(box)
        for name, value in (("position", (1, 2, 3)), ("linear_velocity", (4, 5, 6)), ("angular_velocity", (0.5, 0.25, 1)),
                            ("rotation", (0, 1, 0, 0)), ("gravity_scale", 0.5), ("name", "box"), ("allow_sleep", False),
                            ("type", cairn.BodyType.kinematic)):
            setattr(body, name, value)
            read = getattr(body, name)
            if isinstance(value, tuple):
                np.testing.assert_allclose(read, value)
            else:
                self.assertEqual(read, value)
        settings = world.settings
        settings.gravity = (0, -1.6, 0)
        settings.substeps = 9
        world.settings = settings
        self.assertEqual(world.settings.substeps, 9)
        world.threads = 2
        self.assertEqual(world.threads, 2)

    def test_definitions_begin_with_the_defaults_of_cpp(self):
        world = cairn.World()
        for name in cairn.WorldDef.__dataclass_fields__:
            read, default = getattr(world.settings, name), getattr(cairn.WorldDef(), name)
            np.testing.assert_equal(read, np.float32(default) if isinstance(default, (float, tuple)) else default, name)
        body = world.create_body()
        shape = world.shape_def(world.add_shape(body, cairn.Sphere()))
        for name in ("density", "user_data", "is_trigger"):
            self.assertEqual(getattr(shape, name), getattr(cairn.ShapeDef(), name))
        for name in cairn.Material.__dataclass_fields__:
            default = getattr(cairn.Material(), name)
            self.assertEqual(getattr(shape.material, name), np.float32(default) if isinstance(default, float) else default)
        self.assertEqual(shape.filter.collides_with, cairn.CollisionFilter().collides_with)

    def test_height_fields_have_holes(self):
        heights = np.zeros((5, 5))
        heights[2, 2] = np.inf
        field = cairn.HeightField(heights, (1, 1))
        self.assertEqual(field.indices.shape, (2 * 16 - 6, 3))
        self.assertEqual(field.vertices.shape, (25, 3))
        world = cairn.World()
        world.add_shape(world.create_body(type="static"), field)
        self.assertIsNone(world.cast_ray((0.1, 1, 0.2), (0, -1, 0), 5))
        self.assertAlmostEqual(world.cast_ray((1.6, 1, 0.2), (0, -1, 0), 5).distance, 1, places=5)

    def test_parts_of_the_ground_have_materials(self):
        rubber = cairn.Material(restitution=0.8, restitution_combine="maximum")
        ground = cairn.HeightField(np.zeros((2, 3)), (4, 4), [rubber], [[0, 1]])
        world = cairn.World()
        world.add_shape(world.create_body(type="static"), ground)
        balls = [world.create_body(position=(x, 1.1, 0)) for x in (-2, 2)]
        for ball in balls:
            world.add_shape(ball, cairn.Sphere(0.1), material=cairn.Material(restitution_combine="multiply"))
        hits, fastest = {}, [0, 0]
        for _ in range(60):
            world.step(1 / 60)
            for hit in world.contact_hits:
                hits[hit.surface_material] = hit
            fastest = [max(f, world.body(ball).linear_velocity[1]) for f, ball in zip(fastest, balls)]
        self.assertEqual(sorted(hits), [0, 1])
        self.assertEqual([world.cast_ray((x, 1, 1), (0, -1, 0), 5).triangle // 2 for x in (-2, 2)], [0, 1])
        self.assertLess(fastest[0], 0.1)
        self.assertGreater(fastest[1], 3)  # the balls land at 4.4 m/s
        with self.assertRaisesRegex(cairn.InvalidValueError, "material_numbers"):
            cairn.Mesh(np.eye(3), [[0, 1, 2]], [rubber], [2])
        with self.assertRaisesRegex(cairn.InvalidValueError, "numbers"):
            cairn.Mesh(np.eye(3), [[0, 1, 2]], [rubber], [1, 1])

    def test_every_shape_comes_back_as_it_was_given(self):
        world = cairn.World()
        body = world.create_body(type="static")
        points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
        for given in (cairn.Sphere(0.3), cairn.Box((1, 2, 3), rounding=0.1), cairn.Plane((1, 1, 0), half_extents=(2, 3)),
                      cairn.Capsule(1, 0.2, 0.1), cairn.Cylinder(1, 0.5, None, 0.02), cairn.Hull(points, 0.05),
                      cairn.Mesh(points, [[0, 1, 2], [0, 2, 3]]), cairn.HeightField(np.where(np.eye(3, 4), np.inf, 1), (1, 2)),
                      cairn.Mesh(points, [[0, 1, 2], [0, 2, 3]], [cairn.Material(restitution=0.5)], [1, 0]),
                      cairn.HeightField(np.zeros((3, 4)), (1, 2), [cairn.Material()], [[0, 1, 0], [1, 1, 0]])):
            shape = world.shape(world.add_shape(body, given))
            self.assertIs(type(shape), type(given))
            names = getattr(type(given), "__dataclass_fields__", None) or [n for n in dir(given) if not n.startswith("_")]
            for name in names:
                if name == "materials":
                    self.assertEqual(repr(shape.materials), repr(given.materials))
                    continue
                np.testing.assert_equal(np.float32(getattr(shape, name)) if name != "faces" and getattr(shape, name) is not None
                                        else getattr(shape, name),
                                        np.float32(getattr(given, name)) if name != "faces" and getattr(given, name) is not None
                                        else getattr(given, name), f"{type(given).__name__}.{name}")

    def test_every_joint_comes_back_as_it_was_given(self):
        world = cairn.World()
        a, b = world.create_body(), world.create_body(position=(1, 0, 0))
        control = cairn.JointControl(limits=cairn.JointRange(-0.5, 0.5, cairn.JointSpring(10, 1)),
                                     motor=cairn.JointMotor(velocity=2, max_force=5), friction=0.25)
        for given in (cairn.FixedJoint(), cairn.BallJoint(0.5, cairn.JointRange(-1, 1)), cairn.HingeJoint(control),
                      cairn.SliderJoint(control), cairn.CylindricalJoint(control, control), cairn.UniversalJoint(control),
                      cairn.DistanceJoint(cairn.JointControl(limits=cairn.JointRange(0, 2))),
                      cairn.WheelJoint(control, None, control), cairn.ServoJoint((1, 2, 3)), cairn.GearJoint(2.5),
                      cairn.RackJoint(0.5), cairn.PulleyJoint((0, 3, 0), (1, 3, 0), 2, 7),
                      cairn.GeneralJoint([cairn.JointLimit("linear", (True, False, True), -0.5, 0.5)],
                                         [cairn.JointDrive(axis=1, stiffness=5)])):
            with self.subTest(type(given).__name__):
                joint = world.create_joint(world.joint_at(a, b, (0, 0, 0), (1, 0, 0), given))
                read = world.joint_def(joint).joint
                self.assertIs(type(read), type(given))
                self.assertEqual(plain(read), plain(given))
                world.destroy_joint(joint)

    def test_a_spring_by_frequency_is_that_of_cpp(self):
        spring = cairn.JointSpring.from_frequency(5, 1)
        omega = np.float32(6.28318531) * np.float32(5)
        self.assertEqual(spring.stiffness, omega * omega)
        self.assertTrue(spring.is_acceleration)

    def test_handles_compare_hash_and_pickle(self):
        world, ground, box = crate()
        self.assertEqual(world.bodies, [ground, box])
        self.assertEqual({ground: 1, box: 2}[pickle.loads(pickle.dumps(box))], 2)
        self.assertFalse(cairn.BodyId())
        self.assertNotEqual(ground, box)
        self.assertLess(ground, box)
        self.assertNotEqual(cairn.ShapeId(box.bits), box)


class Events(unittest.TestCase):
    def test_contacts_triggers_and_sleep_are_told(self):
        world, ground, box = crate(hit_speed=1)
        zone = world.create_body(type="static", position=(0, 3, 0))
        trigger = world.add_shape(zone, cairn.Box((1, 0.5, 1)), is_trigger=True)
        began, inside, hits, slept = [], [], [], []
        for _ in range(400):
            world.step()
            began += world.contact_begins
            inside += [event.inside for event in world.trigger_events if event.trigger == trigger]
            hits += world.contact_hits
            slept += world.sleep_events
        self.assertEqual({began[0].body_a, began[0].body_b}, {ground, box})
        self.assertEqual(inside, [True, False])
        self.assertAlmostEqual(hits[0].approach_speed, np.sqrt(2 * 9.81 * 4.5), delta=0.3)
        self.assertEqual([(event.body, event.asleep) for event in slept], [(box, True)])
        contact, = world.body(box).contacts
        self.assertEqual(contact.point_count, 4)
        self.assertAlmostEqual(abs(contact.normal[1]), 1, places=5)
        total = sum(point.normal_impulse for point in contact.points) * 60
        self.assertAlmostEqual(total, 600 * 9.81, delta=30)

    def test_lists_are_as_long_as_what_is_in_them(self):
        world = cairn.World()
        world.add_shape(world.create_body(type="static"), cairn.Plane())
        ball = world.create_body(position=(0, 0.5, 0))
        world.add_shape(ball, cairn.Sphere(0.5))
        rod = world.create_joint(world.joint_at(cairn.BodyId(), ball, (0, 0.5, 0), (0, 1, 0), cairn.CylindricalJoint()))
        fixed = world.create_joint(world.joint_at(cairn.BodyId(), ball, (0, 0.5, 0), (0, 1, 0), cairn.FixedJoint()))
        world.step(n=2)
        contact, = world.body(ball).contacts
        self.assertEqual((contact.point_count, len(contact.points)), (1, 1))
        self.assertEqual([len(world.joint_state(joint).positions) for joint in (rod, fixed)], [2, 0])

    def test_a_joint_that_breaks_is_told(self):
        world = cairn.World()
        body = world.create_body(mass=10)
        world.add_shape(body, cairn.Sphere(0.5))
        definition = world.joint_at(cairn.BodyId(), body, (0, 0, 0), (1, 0, 0), cairn.FixedJoint())
        definition.break_force = 50
        definition.name = "thread"
        joint = world.create_joint(definition)
        self.assertEqual(world.find_joint("thread"), joint)
        world.step(n=3)
        self.assertEqual(world.joints, [])
        self.assertFalse(world.is_valid(joint))


def plain(value):
    """Converts a dataclass to nested tuples, with numbers rounded to 32-bit floats."""
    if hasattr(type(value), "__dataclass_fields__"):
        return tuple(plain(getattr(value, name)) for name in type(value).__dataclass_fields__)
    if isinstance(value, (list, tuple, np.ndarray)):
        return tuple(plain(v) for v in value)
    if isinstance(value, str):
        return cairn.JointAxis[value]
    return float(np.float32(value)) if isinstance(value, (int, float, np.floating)) and not isinstance(value, bool) else value


if __name__ == "__main__":
    unittest.main()
