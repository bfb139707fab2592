"""cairn.rollout: the results are the same as those of worlds that are simulated one by one."""
import _thread
import threading
import time
import unittest

import numpy as np

import cairn


def stack():
    world = cairn.World()
    ground = world.create_body(type="static")
    floor = world.add_shape(ground, cairn.Plane())
    boxes = []
    for i in range(4):
        boxes.append(world.create_body(position=(0.1 * i, 0.5 + 1.01 * i, 0)))
        world.add_shape(boxes[-1], cairn.Box((0.5, 0.5, 0.5)))
    arm = world.create_body(position=(4, 2, 0))
    world.add_shape(arm, cairn.Box((0.5, 0.1, 0.1)))
    hinge = world.create_joint(world.joint_at(cairn.BodyId(), arm, (3.5, 2, 0), (0, 0, 1), cairn.HingeJoint()))
    return world, floor, boxes, hinge


class Rollout(unittest.TestCase):
    def setUp(self):
        self.world, self.floor, self.boxes, self.hinge = stack()
        self.world.step(n=5)
        random = np.random.default_rng(2)
        self.n, self.steps = 13, 24
        self.velocity = random.normal(0, 3, (self.n, 3))
        self.force = random.normal(0, 4000, (self.n, self.steps, 3))
        self.friction = random.uniform(0, 1, self.n)
        self.motor = random.normal(0, 3, self.n)
        self.gravity = np.stack([0 * self.friction, -5 - 5 * self.friction, 0 * self.friction], axis=1)
        self.parameters = {"gravity": self.gravity, (self.boxes[3], "linear_velocity"): self.velocity,
                           (self.boxes[0], "force"): self.force, (self.floor, "friction"): self.friction,
                           (self.hinge, "motor_velocity"): self.motor}

    def one(self, i):
        """Simulates world `i` without rollout, by ordinary calls."""
        world = cairn.World()
        world.restore(self.world.save())
        settings = world.settings
        settings.gravity = self.gravity[i]
        world.settings = settings
        world.body(self.boxes[3]).linear_velocity = self.velocity[i]
        material = world.shape_def(self.floor).material
        material.static_friction = material.dynamic_friction = self.friction[i]
        world.set_material(self.floor, material)
        joint = world.joint_def(self.hinge).joint
        joint.angle.motor = cairn.JointMotor(velocity=self.motor[i])
        world.set_joint(self.hinge, joint)
        frames = []
        for step in range(self.steps):
            world.body(self.boxes[0]).add_force(self.force[i, step])
            world.step()
            frames.append((world.positions.copy(), world.rotations.copy(), world.velocities.copy(),
                           world.angular_velocities.copy(), world.kinetic_energy, world.potential_energy, world.state_hash))
        return frames

    def test_it_is_what_worlds_do_one_by_one_on_any_number_of_threads(self):
        names = ["positions", "rotations", "velocities", "angular_velocities", "kinetic_energy", "potential_energy", "state_hash"]
        before = self.world.state_hash
        expected = [self.one(i) for i in range(self.n)]
        for threads in (1, 2, 5):
            run = cairn.rollout(self.world, self.parameters, self.steps, record=names, threads=threads)
            self.assertEqual(run["positions"].shape, (self.n, self.steps, len(self.world.bodies), 3))
            self.assertEqual(run["state_hash"].shape, (self.n, self.steps))
            for column, name in enumerate(names):
                np.testing.assert_array_equal(run[name], np.array([[f[column] for f in frames] for frames in expected]), name)
        self.assertEqual(self.world.state_hash, before)

    def test_frames_are_taken_after_every_so_many_steps(self):
        every = cairn.rollout(self.world, self.parameters, self.steps, record="state_hash")["state_hash"]
        seventh = cairn.rollout(self.world, self.parameters, self.steps, record="state_hash", every=7)["state_hash"]
        np.testing.assert_array_equal(seventh, every[:, [6, 13, 20]])

    def test_wrong_parameters_are_named(self):
        def expect(kind, text, parameters, **options):
            with self.assertRaises(kind) as caught:
                cairn.rollout(self.world, parameters, 4, **options)
            self.assertIn(text, str(caught.exception))

        expect(ValueError, "(13, 3), or (13, 4, 3) for a value in each step, got (13, 2)", {"gravity": np.zeros((13, 2))})
        expect(cairn.InvalidValueError, "must be one of gravity, substeps", {"gravitty": np.zeros(3)})
        expect(cairn.InvalidValueError, "must be one of position", {(self.boxes[0], "gravity"): np.zeros((2, 3))})
        expect(TypeError, "must be of a body, shape or joint", {("box", "mass"): np.zeros(2)})
        expect(ValueError, "a value for each world", {"substeps": 5})
        expect(ValueError, "worlds: must be given", {})
        expect(ValueError, "got (3, 3)", {"gravity": np.zeros((2, 3)), (self.boxes[0], "position"): np.zeros((3, 3))})
        expect(cairn.InvalidValueError, "must be of positions", {"gravity": np.zeros((2, 3))}, record=["places"])
        expect(cairn.InvalidValueError, "threads", {"gravity": np.zeros((2, 3))}, threads=0)
        expect(cairn.InvalidValueError, "every", {"gravity": np.zeros((2, 3))}, every=0)
        expect(cairn.InvalidHandleError, "world 0", {(cairn.BodyId(99), "mass"): np.ones(2)})

    def test_the_first_world_that_fails_is_named(self):
        gravity = self.gravity.copy()
        gravity[8] = np.nan
        gravity[11] = np.inf
        for threads in (1, 3):
            with self.assertRaises(cairn.InvalidValueError) as caught:
                cairn.rollout(self.world, {"gravity": gravity}, 5, threads=threads)
            self.assertTrue(str(caught.exception).startswith("world 8: WorldDef.gravity"), caught.exception)
            self.assertIn("nan", caught.exception.value)

    def test_no_worlds_and_no_steps_give_empty_arrays(self):
        self.assertEqual(cairn.rollout(self.world, worlds=0, steps=3)["positions"].shape[:2], (0, 3))
        self.assertEqual(cairn.rollout(self.world, worlds=3, steps=0)["positions"].shape[:2], (3, 0))

    def test_ctrl_c_ends_it(self):
        threading.Timer(0.3, _thread.interrupt_main).start()
        begin = time.perf_counter()
        with self.assertRaises(KeyboardInterrupt):
            cairn.rollout(self.world, worlds=100_000, steps=1000, record=["state_hash"], every=1000)
        self.assertLess(time.perf_counter() - begin, 5)

    def test_ctrl_c_ends_many_steps(self):
        threading.Timer(0.3, _thread.interrupt_main).start()
        with self.assertRaises(KeyboardInterrupt):
            self.world.body(self.boxes[0]).allow_sleep = False
            self.world.step(n=2**40)
        self.world.step()
        self.assertEqual(len(self.world.positions), len(self.world.bodies))


if __name__ == "__main__":
    unittest.main()
