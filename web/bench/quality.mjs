// Quality of a state, computed from the poses alone, with the same measure for all engines.
import { World } from 'cairn-physics';

/**
 * The 99th percentile of the overlaps of touching pairs in meters, according to Cairn's contact points in a world with
 * these poses, without gravity and motion.
 */
export function overlap({ bodies, collides = true }, { positions, rotations }) {
    if (!collides) return null;
    const world = new World({ gravity: [0, 0, 0], enableSleep: false });
    bodies.forEach(({ fixed, shape: { half, ...shape } }, i) => {
        const body = world.createBody({
            type: fixed ? 'static' : 'dynamic',
            position: positions.slice(3 * i, 3 * i + 3),
            rotation: rotations.slice(4 * i, 4 * i + 4),
        });
        body.addShape(half ? { kind: 'box', halfExtents: half } : shape);
    });
    world.step(1e-6);
    const depths = world.contacts.map(({ points, pointCount }) =>
        Math.max(0, ...points.slice(0, pointCount).map(({ separation }) => -separation)),
    );
    world.dispose();
    depths.sort((a, b) => a - b);
    return depths.length === 0 ? 0 : depths[Math.floor(0.99 * (depths.length - 1))];
}

/** The mean distance in meters between the two anchors of each joint. */
export function gap({ bodies, joints }, { positions, rotations }) {
    if (joints.length === 0) return null;
    const place = (index, anchor) => {
        const v = anchor.map((x, i) => x - bodies[index].position[i]);
        const [x, y, z, w] = rotations.slice(4 * index, 4 * index + 4);
        const t = [2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])];
        const turned = [
            v[0] + w * t[0] + y * t[2] - z * t[1],
            v[1] + w * t[1] + z * t[0] - x * t[2],
            v[2] + w * t[2] + x * t[1] - y * t[0],
        ];
        return turned.map((c, i) => c + positions[3 * index + i]);
    };
    const gaps = joints.map(({ a, b, anchor }) => {
        const p = place(a, anchor),
            q = place(b, anchor);
        return Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    });
    return gaps.reduce((sum, x) => sum + x, 0) / gaps.length;
}

/** Whether the state is invalid: a position is not finite, or a body has fallen out of the scene. */
export function isLost({ positions }) {
    return Array.from(positions).some((x, i) => !Number.isFinite(x) || (i % 3 === 1 && x < -50));
}
