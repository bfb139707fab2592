// The measured scenes: about 1,000 bodies each, as plain data from which every engine builds its world.

const BOX = { kind: 'box', half: [0.5, 0.5, 0.5] };
const BALL = { kind: 'sphere', radius: 0.5 };
const CAPSULE = { kind: 'capsule', halfHeight: 0.35, radius: 0.3 };

// Random numbers from -1 to 1, the same in every run.
function random(seed) {
    let state = seed >>> 0;
    return () => {
        state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
        return (state >>> 8) / (1 << 23) - 1;
    };
}

function turned(next) {
    const q = [next(), next(), next(), 1.1];
    const length = Math.hypot(...q);
    return q.map((x) => x / length);
}

// A floor with four walls around it: boxes with a half width of half a meter.
function room(half, height) {
    const wall = (x, z, hx, hz) => ({
        fixed: true,
        position: [x, height, z],
        rotation: [0, 0, 0, 1],
        shape: { kind: 'box', half: [hx, height, hz] },
    });
    return [
        {
            fixed: true,
            position: [0, -0.5, 0],
            rotation: [0, 0, 0, 1],
            shape: { kind: 'box', half: [half + 1, 0.5, half + 1] },
        },
        wall(half + 0.5, 0, 0.5, half + 1),
        wall(-half - 0.5, 0, 0.5, half + 1),
        wall(0, half + 0.5, half + 1, 0.5),
        wall(0, -half - 0.5, half + 1, 0.5),
    ];
}

function pile(shapes) {
    const next = random(7),
        bodies = room(9, 12);
    for (let i = 0; i < 1000; ++i) {
        const [x, y, z] = [i % 10, Math.floor(i / 100), Math.floor(i / 10) % 10];
        bodies.push({
            position: [1.75 * (x - 4.5) + 0.01 * next(), 0.9 + 1.75 * y, 1.75 * (z - 4.5) + 0.01 * next()],
            rotation: turned(next),
            shape: shapes[i % shapes.length],
        });
    }
    return { bodies, joints: [] };
}

function pyramid() {
    const bodies = room(60, 0.5);
    const rows = 44; // 990 boxes
    for (let row = 0; row < rows; ++row) {
        for (let i = 0; i < rows - row; ++i) {
            bodies.push({ position: [i - (rows - row - 1) / 2, 0.5 + row, 0], rotation: [0, 0, 0, 1], shape: BOX });
        }
    }
    return { bodies, joints: [] };
}

// A net of 32 x 32 balls, 1 m apart, that hangs by one edge; its bodies do not collide.
function jointGrid() {
    const bodies = [],
        joints = [],
        side = 32;
    for (let row = 0; row < side; ++row) {
        for (let column = 0; column < side; ++column) {
            const index = bodies.length,
                at = [column, 0, row];
            bodies.push({
                fixed: row === 0,
                position: at,
                rotation: [0, 0, 0, 1],
                shape: { kind: 'sphere', radius: 0.4 },
            });
            const anchor = (other) => at.map((x, i) => (x + bodies[other].position[i]) / 2);
            if (column > 0 && row > 0) joints.push({ a: index - 1, b: index, anchor: anchor(index - 1) });
            if (row > 0) joints.push({ a: index - side, b: index, anchor: anchor(index - side) });
        }
    }
    return { bodies, joints, collides: false };
}

export const SCENES = {
    pile_boxes: () => pile([BOX]),
    pile_mixed: () => pile([BOX, BALL, CAPSULE]),
    pyramid,
    joint_grid: jointGrid,
};
export const FRICTION = 0.6,
    DENSITY = 1000,
    GRAVITY = 10,
    STEP = 1 / 60;
