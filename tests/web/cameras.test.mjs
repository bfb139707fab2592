// The initial cameras of scenes in the playground.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { cameraOf, halfHeight } from '../../web/playground/cameras.js';

const near = (a, b) => a.forEach((value, i) => assert.ok(Math.abs(value - b[i]) < 1e-6, `${a} is not ${b}`));

test('a scene without a camera has the default camera', () => {
    assert.equal(cameraOf({}).orthographic, false);
    assert.equal(cameraOf({ scenes: [{ nodes: [0] }], nodes: [{}] }).vertical_fov_degrees, 45);
});

test('an orthographic camera of CAIRN_world stays orthographic', () => {
    const camera = { position: [0, 0, 10], target: [0, 0, 0], vertical_fov_degrees: 90, orthographic: true };
    const found = cameraOf({ scenes: [{ extensions: { CAIRN_world: { camera } } }] });
    assert.ok(found.orthographic);
    assert.ok(Math.abs(halfHeight(found) - 10) < 1e-9);
});

test('an orthographic camera of a glTF file shows the height that the file specifies', () => {
    const half = Math.SQRT1_2; // quaternion component of a rotation by 90 degrees about y: the camera looks along -x
    const found = cameraOf({
        scenes: [{ nodes: [0] }],
        nodes: [
            { translation: [1, 2, 0], children: [1, 2] },
            {},
            { rotation: [0, half, 0, half], translation: [6, 0, 0], camera: 0 },
        ],
        cameras: [{ type: 'orthographic', orthographic: { xmag: 4, ymag: 3, znear: 0.1, zfar: 100 } }],
    });
    near(found.position, [7, 2, 0]);
    near(found.target, [0, 2, 0]);
    assert.ok(found.orthographic);
    assert.ok(Math.abs(halfHeight(found) - 3) < 1e-6);
});

test('a perspective camera of a glTF file keeps its field of view', () => {
    const found = cameraOf({
        scenes: [{ nodes: [0] }],
        nodes: [{ camera: 0, translation: [0, 0, 5] }],
        cameras: [{ type: 'perspective', perspective: { yfov: 0.8, znear: 0.1 } }],
    });
    assert.equal(found.orthographic, false);
    assert.ok(Math.abs((found.vertical_fov_degrees * Math.PI) / 180 - 0.8) < 1e-9);
    near(found.target, [0, 0, 0]);
});
