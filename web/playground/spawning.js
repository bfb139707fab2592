// Adds bodies that fall into the scene where the camera looks.
import { Geometry } from 'cairn-physics';

const phi = (1 + Math.sqrt(5)) / 2;
const icosahedron = [
    0,
    1,
    phi,
    0,
    1,
    -phi,
    0,
    -1,
    phi,
    0,
    -1,
    -phi,
    1,
    phi,
    0,
    1,
    -phi,
    0,
    -1,
    phi,
    0,
    -1,
    -phi,
    0,
    phi,
    0,
    1,
    phi,
    0,
    -1,
    -phi,
    0,
    1,
    -phi,
    0,
    -1,
];

const SHAPES = {
    box: () => ({ kind: 'box', halfExtents: [0.3, 0.3, 0.3] }),
    sphere: () => ({ kind: 'sphere', radius: 0.3 }),
    capsule: () => ({ kind: 'capsule', halfHeight: 0.3, radius: 0.2 }),
    cylinder: () => ({ kind: 'cylinder', halfHeight: 0.3, radius: 0.25 }),
    cone: () => ({ kind: 'cylinder', halfHeight: 0.3, radius: 0.35, radiusTop: 0 }),
    hull: () => ({ kind: 'hull', geometry: Geometry.hull(icosahedron.map((x) => 0.18 * x)) }),
};
export const KINDS = Object.keys(SHAPES);

/** Drops a body from above the camera's target. */
export function spawn(simulation, kind, { target }) {
    simulation.touched = true;
    const { world } = simulation;
    const hit = world.castRay([target.x, target.y + 20, target.z], [0, -1, 0], 40);
    const shape = SHAPES[kind]();
    const body = world.createBody({ position: [target.x, (hit ? hit.point.y : target.y) + 2, target.z] });
    body.addShape(shape, { density: 500 });
    shape.geometry?.dispose();
    return body;
}
