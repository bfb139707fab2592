// The engines behind a common interface of four calls: create the world of a scene, step by 1/60 s, read the poses,
// end. All use their default settings except for gravity, friction, density and damping (none); nothing falls asleep.
import { havok } from './havok.mjs';
import { physx } from './physx.mjs';
import { DENSITY, FRICTION, GRAVITY, STEP } from './scenes.mjs';

const local = (body, point) => point.map((x, i) => x - body.position[i]); // for bodies without rotation
const xyz = ([x, y, z]) => ({ x, y, z });

async function cairn() {
    const { default: init, World, version } = await import('cairn-physics');
    await init();
    return {
        name: `Cairn ${version()}`,
        make({ bodies, joints, collides = true }) {
            const world = new World({ gravity: [0, -GRAVITY, 0], enableSleep: false });
            const made = bodies.map(({ fixed, position, rotation, shape }) => {
                const body = world.createBody({ type: fixed ? 'static' : 'dynamic', position, rotation });
                const { half, ...others } = shape;
                body.addShape(half ? { kind: 'box', halfExtents: half } : others, {
                    density: DENSITY,
                    material: { staticFriction: FRICTION, dynamicFriction: FRICTION },
                    ...(collides ? {} : { filter: { layers: 0n, collidesWith: 0n } }),
                });
                return body;
            });
            for (const { a, b, anchor } of joints)
                world.createJoint(world.jointAt(made[a], made[b], anchor, [1, 0, 0], { kind: 'ball' }));
            return {
                step: () => world.step(STEP),
                poses: () => ({ positions: world.positions, rotations: world.rotations }),
                end: () => world.dispose(),
            };
        },
    };
}

async function rapier() {
    const { default: R } = await import('@dimforge/rapier3d-simd-compat');
    await R.init();
    return {
        name: `Rapier ${R.version()} (simd)`,
        make({ bodies, joints, collides = true }) {
            const world = new R.World({ x: 0, y: -GRAVITY, z: 0 });
            world.timestep = STEP;
            const made = bodies.map(({ fixed, position, rotation: [x, y, z, w], shape }) => {
                const body = world.createRigidBody(
                    (fixed ? R.RigidBodyDesc.fixed() : R.RigidBodyDesc.dynamic())
                        .setTranslation(...position)
                        .setRotation({ x, y, z, w })
                        .setCanSleep(false),
                );
                const desc =
                    shape.kind === 'box'
                        ? R.ColliderDesc.cuboid(...shape.half)
                        : shape.kind === 'sphere'
                          ? R.ColliderDesc.ball(shape.radius)
                          : R.ColliderDesc.capsule(shape.halfHeight, shape.radius);
                world.createCollider(
                    desc
                        .setFriction(FRICTION)
                        .setDensity(DENSITY)
                        .setCollisionGroups(collides ? 0xffffffff : 0),
                    body,
                );
                return body;
            });
            for (const { a, b, anchor } of joints)
                world.createImpulseJoint(
                    R.JointData.spherical(xyz(local(bodies[a], anchor)), xyz(local(bodies[b], anchor))),
                    made[a],
                    made[b],
                    true,
                );
            return {
                step: () => world.step(),
                poses: () => ({
                    positions: made.flatMap((body) => Object.values(body.translation())),
                    rotations: made.flatMap((body) => {
                        const { x, y, z, w } = body.rotation();
                        return [x, y, z, w];
                    }),
                }),
                end: () => world.free(),
            };
        },
    };
}

async function jolt() {
    const { default: initJolt } = await import('jolt-physics');
    const J = await initJolt();
    const FIXED = 0,
        MOVING = 1;
    return {
        name: 'Jolt (jolt-physics 1.1.0)',
        make({ bodies, joints, collides = true }) {
            const settings = new J.JoltSettings();
            settings.mMaxBodies = 4096;
            settings.mMaxBodyPairs = 16384;
            settings.mMaxContactConstraints = 16384;
            const pairs = new J.ObjectLayerPairFilterTable(2);
            if (collides) {
                pairs.EnableCollision(FIXED, MOVING);
                pairs.EnableCollision(MOVING, MOVING);
            }
            const layers = new J.BroadPhaseLayerInterfaceTable(2, 2);
            layers.MapObjectToBroadPhaseLayer(FIXED, new J.BroadPhaseLayer(0));
            layers.MapObjectToBroadPhaseLayer(MOVING, new J.BroadPhaseLayer(1));
            settings.mObjectLayerPairFilter = pairs;
            settings.mBroadPhaseLayerInterface = layers;
            settings.mObjectVsBroadPhaseLayerFilter = new J.ObjectVsBroadPhaseLayerFilterTable(layers, 2, pairs, 2);
            const engine = new J.JoltInterface(settings);
            J.destroy(settings);
            const system = engine.GetPhysicsSystem(),
                all = system.GetBodyInterface();
            system.SetGravity(new J.Vec3(0, -GRAVITY, 0));
            const made = bodies.map(({ fixed, position, rotation, shape }) => {
                const form =
                    shape.kind === 'box'
                        ? new J.BoxShape(new J.Vec3(...shape.half), 0.05)
                        : shape.kind === 'sphere'
                          ? new J.SphereShape(shape.radius)
                          : new J.CapsuleShape(shape.halfHeight, shape.radius);
                form.SetDensity?.(DENSITY);
                const creation = new J.BodyCreationSettings(
                    form,
                    new J.RVec3(...position),
                    new J.Quat(...rotation),
                    fixed ? J.EMotionType_Static : J.EMotionType_Dynamic,
                    fixed ? FIXED : MOVING,
                );
                creation.mFriction = FRICTION;
                creation.mAllowSleeping = false;
                creation.mLinearDamping = creation.mAngularDamping = 0;
                const body = all.CreateBody(creation);
                J.destroy(creation);
                all.AddBody(body.GetID(), J.EActivation_Activate);
                return body;
            });
            for (const { a, b, anchor } of joints) {
                const point = new J.PointConstraintSettings();
                point.mPoint1 = point.mPoint2 = new J.RVec3(...anchor);
                system.AddConstraint(point.Create(made[a], made[b]));
            }
            return {
                step: () => engine.Step(STEP, 1),
                poses: () => ({
                    positions: made.flatMap((body) => {
                        const p = body.GetPosition();
                        return [p.GetX(), p.GetY(), p.GetZ()];
                    }),
                    rotations: made.flatMap((body) => {
                        const q = body.GetRotation();
                        return [q.GetX(), q.GetY(), q.GetZ(), q.GetW()];
                    }),
                }),
                end: () => J.destroy(engine),
            };
        },
    };
}

// In steps of 1/480 s, close to its default of 0.002 s: with 1/60 s bodies pass through its soft contacts.
async function mujoco() {
    const { default: load } = await import('@mujoco/mujoco');
    const m = await load();
    const SUBSTEPS = 8;
    return {
        name: 'MuJoCo 3.14.0 (8 steps of 1/480 s)',
        make({ bodies, joints, collides = true }) {
            const size = ({ kind, half, radius, halfHeight }) =>
                kind === 'box' ? half : kind === 'sphere' ? [radius] : [radius, halfHeight];
            // Its capsules have z as their axis, those of the other engines y.
            const upright = ({ kind }) => (kind === 'capsule' ? 'quat="0.70710678 0.70710678 0 0"' : '');
            const meets = collides ? '' : 'contype="0" conaffinity="0"';
            const surface = `density="${DENSITY}" friction="${FRICTION}" ${meets}`;
            const geom = (s) => `<geom type="${s.kind}" size="${size(s).join(' ')}" ${upright(s)} ${surface}/>`;
            const place = ({ position, rotation: [x, y, z, w] }) =>
                `pos="${position.join(' ')}" quat="${w} ${x} ${y} ${z}"`;
            const free = ({ fixed }) => (fixed ? '' : '<freejoint/>');
            const body = (b, i) => `<body name="b${i}" ${place(b)}>${free(b)}${geom(b.shape)}</body>`;
            const connect = ({ a, b, anchor }) =>
                `<connect body1="b${a}" body2="b${b}" anchor="${local(bodies[a], anchor).join(' ')}"/>`;
            const option = `<option timestep="${STEP / SUBSTEPS}" gravity="0 ${-GRAVITY} 0"/>`;
            const xml = `<mujoco><size memory="600M"/>${option}
                <worldbody>${bodies.map(body).join('')}</worldbody>
                <equality>${joints.map(connect).join('')}</equality></mujoco>`;
            const model = m.MjModel.from_xml_string(xml);
            const data = new m.MjData(model);
            return {
                step: () => {
                    for (let i = 0; i < SUBSTEPS; ++i) m.mj_step(model, data);
                },
                poses: () => {
                    const positions = Array.from(data.xpos).slice(3),
                        quaternions = Array.from(data.xquat).slice(4);
                    return {
                        positions,
                        rotations: quaternions.map((_, i) => quaternions[4 * Math.floor(i / 4) + ((i + 1) % 4)]),
                    };
                },
                end: () => {
                    data.delete();
                    model.delete();
                },
            };
        },
    };
}

async function cannon() {
    const C = await import('cannon-es');
    return {
        name: 'cannon-es 0.20.0',
        make({ bodies, joints, collides = true }) {
            const world = new C.World({ gravity: new C.Vec3(0, -GRAVITY, 0) });
            world.broadphase = new C.SAPBroadphase(world);
            world.defaultContactMaterial.friction = FRICTION;
            const volume = ({ kind, half, radius: r, halfHeight: h }) =>
                kind === 'box'
                    ? 8 * half[0] * half[1] * half[2]
                    : Math.PI * r * r * ((4 / 3) * r + (kind === 'capsule' ? 2 * h : 0));
            const made = bodies.map(({ fixed, position, rotation, shape }) => {
                const body = new C.Body({
                    mass: fixed ? 0 : DENSITY * volume(shape),
                    position: new C.Vec3(...position),
                    quaternion: new C.Quaternion(...rotation),
                    linearDamping: 0,
                    angularDamping: 0,
                    collisionResponse: collides,
                    collisionFilterMask: collides ? -1 : 0,
                });
                if (shape.kind === 'box') body.addShape(new C.Box(new C.Vec3(...shape.half)));
                else if (shape.kind === 'sphere') body.addShape(new C.Sphere(shape.radius));
                else {
                    // It has no capsules: two balls and a cylinder replace one.
                    for (const y of [-shape.halfHeight, shape.halfHeight])
                        body.addShape(new C.Sphere(shape.radius), new C.Vec3(0, y, 0));
                    body.addShape(new C.Cylinder(shape.radius, shape.radius, 2 * shape.halfHeight, 8));
                }
                world.addBody(body);
                return body;
            });
            for (const { a, b, anchor } of joints)
                world.addConstraint(
                    new C.PointToPointConstraint(
                        made[a],
                        new C.Vec3(...local(bodies[a], anchor)),
                        made[b],
                        new C.Vec3(...local(bodies[b], anchor)),
                    ),
                );
            return {
                step: () => world.step(STEP),
                poses: () => ({
                    positions: made.flatMap(({ position: p }) => [p.x, p.y, p.z]),
                    rotations: made.flatMap(({ quaternion: q }) => [q.x, q.y, q.z, q.w]),
                }),
                end: () => {},
            };
        },
    };
}

export const ENGINES = { cairn, rapier, jolt, havok, physx, mujoco, cannon };
