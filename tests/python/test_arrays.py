"""The arrays world.positions, rotations, velocities and angular_velocities: they are views of the state of the world, and
raise an error once they are invalid."""
import gc
import time
import unittest

import numpy as np

import cairn

NAMES = ("positions", "rotations", "velocities", "angular_velocities")


def balls(count, seed=5):
    random = np.random.default_rng(seed)
    world = cairn.World()
    ids = []
    for _ in range(count):
        q = random.normal(size=4)
        ids.append(world.create_body(position=random.uniform(-9, 9, 3), rotation=q, linear_velocity=random.normal(size=3),
                                     angular_velocity=random.normal(size=3)))
        world.add_shape(ids[-1], cairn.Sphere(0.2), position=random.uniform(-0.3, 0.3, 3))
    return world, ids


class Follow(unittest.TestCase):
    def expect_true_to(self, world):
        for i, body in enumerate(map(world.body, world.bodies)):
            np.testing.assert_array_equal(world.positions[i], body.position)
            np.testing.assert_array_equal(world.rotations[i], body.rotation)
            np.testing.assert_array_equal(world.velocities[i], body.linear_velocity)
            np.testing.assert_array_equal(world.angular_velocities[i], body.angular_velocity)

    def test_they_say_what_the_bodies_say(self):
        world, ids = balls(600)
        self.expect_true_to(world)
        held = [getattr(world, name) for name in NAMES]
        world.step(n=7)
        self.expect_true_to(world)
        for name, array in zip(NAMES, held):  # the property returns the same array as before the steps
            self.assertIs(getattr(world, name), array)
        self.assertEqual([a.shape for a in held], [(600, 3), (600, 4), (600, 3), (600, 3)])
        self.assertEqual([a.dtype for a in held], [np.float64, np.float32, np.float32, np.float32])

    def test_they_follow_every_call_that_moves_a_body(self):
        world, ids = balls(40)
        body = world.body(ids[17])
        held = world.positions, world.velocities, world.rotations, world.angular_velocities
        changes = [lambda: setattr(body, "position", (1, 2, 3)), lambda: body.set_transform((4, 5, 6), (0, 0, 1, 0)),
                   lambda: setattr(body, "rotation", (1, 0, 0, 0)), lambda: setattr(body, "linear_velocity", (7, 8, 9)),
                   lambda: setattr(body, "angular_velocity", (1, 1, 1)), lambda: body.apply_impulse((100, 0, 0)),
                   lambda: body.apply_impulse_at((0, 50, 0), (0, 0, 0)), lambda: body.apply_angular_impulse((0, 0, 9)),
                   lambda: world.add_shape(body, cairn.Box((1, 1, 1)), position=(2, 0, 0)),
                   lambda: world.remove_shape(body.shapes[0]), lambda: setattr(body, "type", "static")]
        for change in changes:
            change()
            self.expect_true_to(world)
        self.assertIs(held[0], world.positions)

    def test_they_cannot_be_written_into(self):
        world, ids = balls(3)
        for name in NAMES:
            array = getattr(world, name)
            with self.assertRaises(ValueError):
                array[0, 0] = 5
            with self.assertRaises(ValueError):
                array += 1
            with self.assertRaises(ValueError):
                array.flags.writeable = True
                array[0] = 1
                raise AssertionError("written")
        with self.assertRaises(ValueError):
            world.body(ids[0]).position[0] = 3  # position returns a copy, so that the write would have no effect

    def test_what_is_computed_from_them_is_plain_and_stays(self):
        world, ids = balls(30)
        p = world.positions
        total, double, picked, copied = p.sum(axis=0), 2 * p, p[p[:, 1] > 0], p.copy()
        self.assertIs(type(double), np.ndarray)
        self.assertIs(type(np.concatenate([p, p])), np.ndarray)
        before = copied.copy()
        world.step(n=10)
        np.testing.assert_array_equal(copied, before)
        world.create_body()
        np.testing.assert_array_equal(copied, before)
        self.assertEqual(total.shape, (3,))
        self.assertIs(type(picked), np.ndarray)
        self.assertTrue((picked[:, 1] > 0).all())


class Retire(unittest.TestCase):
    def expect_retired(self, array, reason):
        column = None
        for use in (lambda: array[0], lambda: array[:, 1], lambda: array + 1, lambda: np.sum(array), lambda: array.mean(),
                    lambda: list(array), lambda: np.concatenate([array, array]), lambda: array.copy(), lambda: array.tolist(),
                    lambda: array == 0, lambda: array.astype(float), lambda: np.linalg.norm(array, axis=1), lambda: str(array)):
            with self.assertRaises(cairn.WrongStateError) as caught:
                column = use()
            self.assertIn(reason, str(caught.exception))
        self.assertIsNone(column)

    def test_after_bodies_came_or_went(self):
        for change, reason in ((lambda w, ids: w.create_body(), "a body was created"),
                               (lambda w, ids: w.destroy_body(ids[2]), "a body was destroyed"),
                               (lambda w, ids: w.restore(w.save()), "another state was restored"),
                               (lambda w, ids: w.close(), "the world is closed")):
            world, ids = balls(5)
            arrays = [getattr(world, name) for name in NAMES]
            parts = [a[1:, 0] for a in arrays]
            change(world, ids)
            for array in arrays + parts:
                self.expect_retired(array, reason)
            if not world.closed:
                self.assertEqual(len(world.positions), len(world.bodies))

    def test_a_call_that_is_refused_retires_nothing(self):
        world, ids = balls(5)
        p = world.positions
        with self.assertRaises(cairn.InvalidValueError):
            world.create_body(mass=-1)
        with self.assertRaises(cairn.InvalidHandleError):
            world.destroy_body(cairn.BodyId())
        self.assertIs(p, world.positions)
        self.assertEqual(p[0].shape, (3,))

    def test_their_memory_outlives_the_world(self):
        world, ids = balls(2000)
        p = world.positions
        plain, expected = np.asarray(p), p.copy()
        del world
        gc.collect()
        np.testing.assert_array_equal(plain, expected)
        self.expect_retired(p, "the world is gone")


class Speed(unittest.TestCase):
    @staticmethod
    def best(call, rounds=7):
        times = []
        for _ in range(rounds):
            begin = time.perf_counter()
            call()
            times.append(time.perf_counter() - begin)
        return min(times)

    def test_positions_of_10000_bodies_take_less_than_20_microseconds(self):
        world, _ = balls(10_000)
        world.positions

        def read():
            for _ in range(1000):
                world.positions

        self.assertLess(self.best(read) / 1000, 20e-6)

    def test_a_million_scalar_calls_take_less_than_400_milliseconds(self):
        world, ids = balls(1)
        body = world.body(ids[0])

        def read():
            for _ in range(200_000):
                body.mass

        self.assertLess(5 * self.best(read), 0.4)


if __name__ == "__main__":
    unittest.main()
