"""A ball falls for one second. Its position is compared with v t + g t^2 / 2."""
import cairn

world = cairn.World(gravity=(0, -9.81, 0), max_linear_speed=1e4)
ball = world.create_body(position=(0, 100, 0), linear_velocity=(3, 0, 0))
world.add_shape(ball, cairn.Sphere(0.5))
dt, steps = 1 / 1000, 1000
world.step(dt, n=steps)
x, y, _ = world.body(ball).position
expected = 100 - 9.81 * 1.0**2 / 2
print(f"after {world.time:.3f} s the ball is at x = {x:.4f} m, y = {y:.4f} m; expected 3 and {expected:.4f}")
assert abs(x - 3) < 1e-3 and abs(y - expected) < 5e-3
