// PhysX behind the four calls of engines.mjs.
import { readFile } from 'node:fs/promises';
import load from 'physx-js-webidl';
import { DENSITY, FRICTION, GRAVITY, STEP } from './scenes.mjs';

// Its loader does not work if there is Node's `process`, and takes an environment with a `window` for a web page.
async function loaded() {
    const wasmBinary = await readFile(new URL(import.meta.resolve('physx-js-webidl/physx-js-webidl.wasm')));
    const { process } = globalThis;
    try {
        Object.assign(globalThis, { process: undefined, window: globalThis });
        return load({ wasmBinary });
    } finally {
        globalThis.process = process;
        delete globalThis.window;
    }
}

export async function physx() {
    const P = await loaded();
    const F = P.PxTopLevelFunctions.prototype; // any prototype of the package that has the static functions
    const foundation = F.CreateFoundation(
        P.PHYSICS_VERSION,
        new P.PxDefaultAllocator(),
        new P.PxDefaultErrorCallback(),
    );
    const scale = new P.PxTolerancesScale();
    const physics = F.CreatePhysics(P.PHYSICS_VERSION, foundation, scale);
    F.InitExtensions(physics);
    const pose = ([x, y, z], [qx, qy, qz, qw] = [0, 0, 0, 1]) =>
        new P.PxTransform(new P.PxVec3(x, y, z), new P.PxQuat(qx, qy, qz, qw));
    // Its capsules have x as their axis, those of the other engines y.
    const upright = pose([0, 0, 0], [0, 0, Math.SQRT1_2, Math.SQRT1_2]);
    const formOf = ({ kind, half, radius, halfHeight }) =>
        kind === 'box'
            ? new P.PxBoxGeometry(...half)
            : kind === 'sphere'
              ? new P.PxSphereGeometry(radius)
              : new P.PxCapsuleGeometry(radius, halfHeight);
    const { eSIMULATION_SHAPE, eSCENE_QUERY_SHAPE } = P.PxShapeFlagEnum;
    return {
        name: 'PhysX 5.6.1 (physx-js-webidl 2.7.3)',
        make({ bodies, joints, collides = true }) {
            const description = new P.PxSceneDesc(scale);
            description.gravity = new P.PxVec3(0, -GRAVITY, 0);
            description.cpuDispatcher = F.DefaultCpuDispatcherCreate(0);
            description.filterShader = F.DefaultFilterShader();
            const scene = physics.createScene(description);
            const material = physics.createMaterial(FRICTION, FRICTION, 0);
            const flags = new P.PxShapeFlags((collides ? eSIMULATION_SHAPE : 0) | eSCENE_QUERY_SHAPE);
            const filter = new P.PxFilterData(1, 1, 0, 0);
            const made = bodies.map(({ fixed, position, rotation, shape }) => {
                const form = physics.createShape(formOf(shape), material, true, flags);
                form.setSimulationFilterData(filter);
                if (shape.kind === 'capsule') form.setLocalPose(upright);
                const place = pose(position, rotation);
                const body = fixed ? physics.createRigidStatic(place) : physics.createRigidDynamic(place);
                body.attachShape(form);
                if (!fixed) {
                    P.PxRigidBodyExt.prototype.updateMassAndInertia(body, DENSITY, undefined, true);
                    body.setLinearDamping(0);
                    body.setAngularDamping(0);
                    body.setSleepThreshold(0);
                }
                scene.addActor(body);
                return body;
            });
            const local = (body, anchor) => pose(anchor.map((x, i) => x - bodies[body].position[i]));
            const constraints = joints.map(({ a, b, anchor }) =>
                F.SphericalJointCreate(physics, made[a], local(a, anchor), made[b], local(b, anchor)),
            );
            return {
                step: () => {
                    scene.simulate(STEP);
                    scene.fetchResults(true);
                },
                poses: () => {
                    const positions = [],
                        rotations = [];
                    for (const body of made) {
                        const { p, q } = body.getGlobalPose();
                        positions.push(p.x, p.y, p.z);
                        rotations.push(q.x, q.y, q.z, q.w);
                    }
                    return { positions, rotations };
                },
                end: () => {
                    for (const joint of constraints) joint.release();
                    scene.release();
                    for (const body of made) body.release();
                    material.release();
                },
            };
        },
    };
}
