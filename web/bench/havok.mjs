// Havok, as distributed by Babylon.js, behind the four calls of engines.mjs.
import { readFile } from 'node:fs/promises';
import HavokPhysics from '@babylonjs/havok';
import { DENSITY, FRICTION, GRAVITY, STEP } from './scenes.mjs';

const NO_TURN = [0, 0, 0, 1];
const AXES = [
    [1, 0, 0],
    [0, 1, 0],
];

export async function havok() {
    const address = new URL(import.meta.resolve('@babylonjs/havok/lib/esm/HavokPhysics.wasm'));
    const H = await HavokPhysics({ wasmBinary: await readFile(address) });
    // Each call returns a result code followed by the created objects.
    const must = (result) => {
        const [code, ...made] = Array.isArray(result) ? result : [result];
        if (code !== H.Result.RESULT_OK) throw new Error(`Havok: ${new Error().stack}: ${JSON.stringify(code)}`);
        return made[0];
    };
    const formOf = ({ kind, half, radius, halfHeight: h }) =>
        must(
            kind === 'box'
                ? H.HP_Shape_CreateBox(
                      [0, 0, 0],
                      NO_TURN,
                      half.map((x) => 2 * x),
                  )
                : kind === 'sphere'
                  ? H.HP_Shape_CreateSphere([0, 0, 0], radius)
                  : H.HP_Shape_CreateCapsule([0, -h, 0], [0, h, 0], radius),
        );
    return {
        name: 'Havok 1.3.14',
        make({ bodies, joints, collides = true }) {
            const world = must(H.HP_World_Create());
            must(H.HP_World_SetGravity(world, [0, -GRAVITY, 0]));
            const shapes = [];
            const made = bodies.map(({ fixed, position, rotation, shape }) => {
                const form = formOf(shape);
                shapes.push(form);
                const { MINIMUM, MAXIMUM } = H.MaterialCombine;
                must(H.HP_Shape_SetMaterial(form, [FRICTION, FRICTION, 0, MINIMUM, MAXIMUM]));
                must(H.HP_Shape_SetDensity(form, DENSITY));
                if (!collides) must(H.HP_Shape_SetFilterInfo(form, [0, 0]));
                const body = must(H.HP_Body_Create());
                must(H.HP_Body_SetShape(body, form));
                must(H.HP_Body_SetMotionType(body, fixed ? H.MotionType.STATIC : H.MotionType.DYNAMIC));
                must(H.HP_Body_SetQTransform(body, [position, rotation]));
                if (!fixed) {
                    must(H.HP_Body_SetMassProperties(body, must(H.HP_Shape_BuildMassProperties(form))));
                    must(H.HP_Body_SetLinearDamping(body, 0));
                    must(H.HP_Body_SetAngularDamping(body, 0));
                    must(H.HP_Body_SetActivationControl(body, H.ActivationControl.ALWAYS_ACTIVE));
                }
                must(H.HP_World_AddBody(world, body, false));
                return body;
            });
            const constraints = joints.map(({ a, b, anchor }) => {
                const local = (body) => anchor.map((x, i) => x - bodies[body].position[i]);
                const joint = must(H.HP_Constraint_Create());
                must(H.HP_Constraint_SetParentBody(joint, made[a]));
                must(H.HP_Constraint_SetChildBody(joint, made[b]));
                must(H.HP_Constraint_SetAnchorInParent(joint, local(a), ...AXES));
                must(H.HP_Constraint_SetAnchorInChild(joint, local(b), ...AXES));
                const { LINEAR_X, LINEAR_Y, LINEAR_Z } = H.ConstraintAxis;
                for (const axis of [LINEAR_X, LINEAR_Y, LINEAR_Z])
                    must(H.HP_Constraint_SetAxisMode(joint, axis, H.ConstraintAxisLimitMode.LOCKED));
                must(H.HP_Constraint_SetEnabled(joint, 1));
                return joint;
            });
            return {
                step: () => must(H.HP_World_Step(world, STEP)),
                poses: () => {
                    const all = made.map((body) => must(H.HP_Body_GetQTransform(body)));
                    return { positions: all.flatMap(([at]) => at), rotations: all.flatMap(([, turn]) => turn) };
                },
                end: () => {
                    for (const joint of constraints) must(H.HP_Constraint_Release(joint));
                    for (const body of made) must(H.HP_World_RemoveBody(world, body));
                    for (const body of made) must(H.HP_Body_Release(body));
                    for (const form of shapes) must(H.HP_Shape_Release(form));
                    must(H.HP_World_Release(world));
                },
            };
        },
    };
}
