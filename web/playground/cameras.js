// The cameras of scene files: that of CAIRN_world, otherwise the first one of the glTF file.

const DEFAULT = { position: [6, 4, 10], target: [0, 1, 0], vertical_fov_degrees: 45, orthographic: false };

/** The initial camera of a scene from the JSON of its file, in the form of CAIRN_world. */
export function cameraOf(json) {
    const scene = json.scenes?.[json.scene ?? 0];
    const own = scene?.extensions?.CAIRN_world?.camera;
    if (own) return { ...DEFAULT, ...own };
    for (const root of scene?.nodes ?? []) {
        const found = firstCamera(json, root, identity());
        if (found) return found;
    }
    return DEFAULT;
}

/** Half the height of the picture at the distance of the target in meters, for a parallel projection. */
export function halfHeight({ position, target, vertical_fov_degrees: angle }) {
    const distance = Math.hypot(...position.map((p, i) => p - target[i]));
    return distance * Math.tan((angle * Math.PI) / 360);
}

function firstCamera(json, index, above) {
    const node = json.nodes[index];
    const place = product(above, matrixOf(node));
    if (node.camera !== undefined) return lookingFrom(place, json.cameras[node.camera]);
    for (const child of node.children ?? []) {
        const found = firstCamera(json, child, place);
        if (found) return found;
    }
    return null;
}

// glTF cameras look along -z and have no target: the target is placed at the distance of the origin.
function lookingFrom(place, camera) {
    const position = [place[12], place[13], place[14]];
    const length = Math.hypot(place[8], place[9], place[10]);
    const forward = [8, 9, 10].map((i) => -place[i] / length);
    const distance = Math.max(1, -position.reduce((sum, p, i) => sum + p * forward[i], 0));
    const target = position.map((p, i) => p + distance * forward[i]);
    const orthographic = camera.type === 'orthographic';
    const half = orthographic ? Math.atan2(camera.orthographic.ymag, distance) : camera.perspective.yfov / 2;
    return { position, target, vertical_fov_degrees: (half * 360) / Math.PI, orthographic };
}

const identity = () => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

// The matrix of a glTF node in column-major order.
function matrixOf({ matrix, translation = [0, 0, 0], rotation = [0, 0, 0, 1], scale = [1, 1, 1] }) {
    if (matrix) return matrix;
    const [x, y, z, w] = rotation;
    const columns = [
        [1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)],
        [2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)],
        [2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)],
    ];
    return [...columns.flatMap((column, i) => [...column.map((value) => value * scale[i]), 0]), ...translation, 1];
}

function product(a, b) {
    const result = [];
    for (let column = 0; column < 4; ++column)
        for (let row = 0; row < 4; ++row)
            result.push([0, 1, 2, 3].reduce((sum, k) => sum + a[4 * k + row] * b[4 * column + k], 0));
    return result;
}
