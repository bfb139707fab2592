// Every generated call is made with one invalid argument, for each argument in turn: the call must throw, and leave the
// world unchanged. With valid arguments it must not throw.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import init, { CairnError, World } from 'cairn-physics';
import { CALLS, ENUMS } from './generated/calls.mjs';

await init();

// A world with one object of each type: body, shape, joint and force field.
function sample() {
    const world = new World();
    const ground = world.createBody({ type: 'static' });
    ground.addShape({ kind: 'plane' });
    const body = world.createBody({ position: [0, 2, 0] });
    const shape = body.addShape({ kind: 'box', halfExtents: [0.5, 0.5, 0.5] });
    const fixed = ground.addShape({ kind: 'box', halfExtents: [1, 1, 1] }, { position: [9, 0, 0] });
    const joint = world.createJoint(world.jointAt(body, null, [0, 3, 0], [1, 0, 0], { kind: 'ball' }));
    const field = world.addForceField({ direction: [0, 1, 0] });
    return { world, body, shape, fixed, joint, field };
}

// A valid argument of a type.
function right(type, { body, shape, fixed, joint, field }, name) {
    const values = {
        BodyId: body,
        JointId: joint,
        ForceFieldId: field,
        ShapeId: name === 'setSurfaceVelocity' ? fixed : shape,
        bool: true,
        int: 1,
        float: 0.5,
        'float?': 0.5,
        double: 10,
        u64: 1n,
        string: 'name',
        Vec3: [0, 1, 0],
        Position: [0, 5, 0],
        Quat: [0, 0, 0, 1],
        Transform: { position: [0, 9, 0] },
        Bounds: { min: [-1, -1, -1], max: [1, 1, 1] },
        Shape: { kind: 'sphere', radius: 0.5 },
        Joint: { kind: 'hinge' },
        JointDef: { bodyA: body, joint: { kind: 'ball' } },
        BodyType: 'kinematic',
    };
    return type in values ? values[type] : {};
}

const WRONG = {
    handle: [0n, 12, 'one', undefined, null, {}, -1n, 1n << 64n, 123456789n, NaN],
    number: ['1', undefined, {}, [], NaN, true, 1n],
    vector: [
        undefined,
        null,
        1,
        'xyz',
        [1, 2],
        [1, 2, 3, 4, 5],
        [1, 'a', 2],
        { x: 1 },
        { x: NaN, y: 0, z: 0, w: 1 },
        [0, Infinity, 0],
        [0, 0, NaN],
        new Float32Array(7),
        [undefined, 1, 1],
    ],
    text: [undefined, null, 1, {}, 'a\0b'],
    truth: [undefined, null, 0, 'true', {}],
    layers: [-1, 1.5, NaN, 'all', -1n, 1n << 64n, null, {}, 2 ** 53],
    object: [null, 5, 'def', [], { nosuch: 1 }, true],
    whole: [1.5, NaN, '1', null, 2 ** 31, -1],
    choice: ['nosuch', 0, null, {}, '', 'Static'],
};
function wrong(type) {
    if (type.endsWith('Id')) return WRONG.handle;
    if (type === 'float?') return ['1', {}, [], true, NaN];
    if (type === 'float' || type === 'double') return WRONG.number;
    if (type === 'int') return WRONG.whole;
    if (type === 'bool') return WRONG.truth;
    if (type === 'u64') return WRONG.layers;
    if (type === 'string') return WRONG.text;
    if (['Vec3', 'Position', 'Quat'].includes(type)) return WRONG.vector;
    if (ENUMS.includes(type)) return WRONG.choice;
    return WRONG.object;
}

function invoke(call, { world, body }, args) {
    const target = call.owner === 'World' ? world : body;
    if (call.isSetter) [target[call.name]] = args;
    else target[call.name](...args);
}

const stateOf = ({ world }) => `${world.stateHash} ${world.saveScene()}`;
let spoiled = 0;

for (const call of CALLS) {
    test(`${call.owner}.${call.name}${call.isSetter ? ' =' : ''} refuses invalid arguments`, () => {
        const ready = sample();
        const needsCharacter = ['walkVelocity', 'jump', 'removeCharacter'].includes(call.name);
        if (needsCharacter || ['moveTo', 'character'].includes(call.name)) ready.body.type = 'kinematic';
        if (needsCharacter) ready.body.character = {};
        const args = call.types.map((type) => right(type, ready, call.name));
        const before = stateOf(ready);
        call.types.forEach((type, position) => {
            for (const value of wrong(type)) {
                ++spoiled;
                const tried = args.with?.(position, value) ?? args.map((arg, i) => (i === position ? value : arg));
                const text = typeof value === 'object' ? JSON.stringify(value) : String(value);
                const shown = `argument ${position} (${type}): ${text}`;
                assert.throws(
                    () => invoke(call, ready, tried),
                    (error) => error instanceof CairnError && error.message.length > 10,
                    shown,
                );
                assert.equal(stateOf(ready), before, shown);
            }
        });
        invoke(call, ready, args);
        ready.world.step();
        ready.world.dispose();
    });
}

test('the tests above made several hundred calls', () =>
    assert.ok(CALLS.length > 40 && spoiled > 500, `${CALLS.length} calls, ${spoiled} times`));
