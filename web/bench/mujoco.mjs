// Compares Cairn with MuJoCo on MJCF models that both read, in Node, on one thread, both as WebAssembly: steps per
// second of processor time, and the distance of the bodies from the engine's own run with small steps (after Erez,
// Tassa and Todorov, ICRA 2015). bench/mujoco.cpp does the same natively.
//
// From states along the run with small steps, pieces of 128 ms are simulated with longer steps. The deviation is the
// mean distance of the bodies from their positions at the end of the piece with small steps. The processor time is that
// of the pieces.
import { readFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { parseArgs } from 'node:util';

const SHORTEST = 0.001 / 64, // s
    PIECE = 0.128,
    BETWEEN = 0.16,
    DOUBLINGS = [0, 6, 7, 8, 9, 10]; // the reference, then 1 to 16 ms
const USAGE = `usage: ./dev bench --mujoco --web [--models NAME,...] [--pieces N] [--rounds N]
  --models    of ragdoll, ten_boxes (both): files of web/bench/models
  --pieces    of 128 ms, from so many states of a fall (12)
  --rounds    of timing, of which the median is taken (5)
Prints steps a second of the processor and mm of deviation, at the same steps in both engines.`;

function options() {
    try {
        const { values } = parseArgs({
            options: {
                models: { type: 'string', default: 'ragdoll,ten_boxes' },
                pieces: { type: 'string', default: '12' },
                rounds: { type: 'string', default: '5' },
                help: { type: 'boolean' },
            },
        });
        if (values.help) {
            console.log(USAGE);
            process.exit(0);
        }
        const number = (name) => {
            const value = Number(values[name]);
            if (!Number.isInteger(value) || value < 1 || value > 1000)
                throw new TypeError(`--${name} ${values[name]}: must be a whole number from 1 to 1000`);
            return value;
        };
        const models = values.models.split(',');
        for (const name of models)
            if (!['ragdoll', 'ten_boxes'].includes(name))
                throw new TypeError(`--models: there is no ${name}, only ragdoll, ten_boxes`);
        return { models, pieces: number('pieces'), rounds: number('rounds') };
    } catch (error) {
        console.error(`bench: ${error.message}\n${USAGE}`);
        process.exit(2);
    }
}

/** Cairn with the scene that `cairn convert` made from the model, as the npm package reads only glTF. */
async function cairn() {
    const { default: init, World, version } = await import('cairn-physics');
    await init();
    return {
        name: `Cairn ${version()}`,
        make(model) {
            const scene = new URL(`../../build/web/models/${model}.gltf`, import.meta.url);
            const world = World.load(readFileSync(scene));
            world.settings = { ...world.settings, enableSleep: false };
            return {
                step: (seconds) => world.step(seconds),
                save: () => world.save(),
                restore: (state) => world.restore(state),
                // The first body is the floor.
                positions: () => Array.from(world.positions).slice(3),
                end: () => world.dispose(),
            };
        },
    };
}

async function mujoco() {
    const { default: load } = await import('@mujoco/mujoco');
    const m = await load();
    return {
        name: 'MuJoCo 3.14.0',
        make(name) {
            const xml = readFileSync(new URL(`models/${name}.xml`, import.meta.url), 'utf8');
            const model = m.MjModel.from_xml_string(xml);
            const data = new m.MjData(model);
            const kept = ['qpos', 'qvel', 'qacc_warmstart'];
            return {
                step: (seconds) => {
                    model.opt.timestep = seconds;
                    m.mj_step(model, data);
                },
                save: () => kept.map((name) => Array.from(data[name])),
                restore: (state) => kept.forEach((name, i) => data[name].set(state[i])),
                // Positions before the last step, unless `forward` is called.
                positions: () => Array.from(data.xpos).slice(3),
                forward: () => m.mj_kinematics(model, data),
                end: () => {
                    data.delete();
                    model.delete();
                },
            };
        },
    };
}

/** Processor time in seconds, on which other programs have less influence. */
function processorSeconds() {
    const { user, system } = process.cpuUsage();
    return (user + system) / 1e6;
}

function places(world) {
    world.forward?.();
    const positions = world.positions();
    if (!positions.every(Number.isFinite)) throw new RangeError('a position is not finite');
    return positions;
}

function meanDistance(one, other) {
    let sum = 0;
    for (let i = 0; i < one.length; i += 3)
        sum += Math.hypot(one[i] - other[i], one[i + 1] - other[i + 1], one[i + 2] - other[i + 2]);
    return (sum * 3) / one.length;
}

function states(world, pieces) {
    const steps = Math.round(BETWEEN / SHORTEST);
    return Array.from({ length: pieces }, () => {
        for (let i = 0; i < steps; ++i) world.step(SHORTEST);
        return world.save();
    });
}

/** Runs the piece from a state; returns the processor time in seconds, and the positions at its end. */
function runPiece(world, state, step) {
    world.restore(state);
    const count = Math.round(PIECE / step);
    const begin = processorSeconds();
    for (let i = 0; i < count; ++i) world.step(step);
    return { seconds: processorSeconds() - begin, count, end: places(world) };
}

const median = (list) => [...list].sort((a, b) => a - b)[list.length >> 1];

/** For each step: the deviation in meters (mean and median over the pieces), and the median of steps per second. */
function measure(world, pieces, rounds) {
    const starts = states(world, pieces);
    const ends = starts.map((state) => runPiece(world, state, SHORTEST).end);
    return DOUBLINGS.slice(1).map((doubling) => {
        const step = SHORTEST * 2 ** doubling;
        let deviations = [];
        const rates = Array.from({ length: rounds }, () => {
            deviations = [];
            let seconds = 0,
                count = 0;
            starts.forEach((state, i) => {
                const piece = runPiece(world, state, step);
                (seconds += piece.seconds), (count += piece.count);
                deviations.push(meanDistance(piece.end, ends[i]));
            });
            return count / seconds;
        });
        const deviation = deviations.reduce((sum, one) => sum + one, 0) / pieces;
        return { step, deviation, ofMiddle: median(deviations), rate: median(rates) };
    });
}

const { models, pieces, rounds } = options();
const engines = [await cairn(), await mujoco()];
console.log(`Node ${process.version}, ${cpus()[0].model}, ${pieces} pieces of 128 ms, median of ${rounds} rounds\n`);
const names = engines.map(({ name }) => name);
const rates = names.map((name) => `${name}, steps a second`);
const far = `deviation (of the middle piece): ${names.join(', ')}, mm`;
console.log(`| model | step, ms | ${rates.join(' | ')} | ratio | ${far} |`);
console.log('|---|---|---|---|---|---|');
for (const model of models) {
    const [ours, theirs] = engines.map(({ name, make }) => {
        console.error(`${model}: ${name}`);
        const world = make(model);
        const points = measure(world, pieces, rounds);
        world.end();
        return points;
    });
    ours.forEach((own, i) => {
        const other = theirs[i];
        const cells = [model, (1000 * own.step).toPrecision(2), own.rate.toFixed(0), other.rate.toFixed(0)];
        const mm = (x) => (1000 * x).toPrecision(2);
        const apart = [own, other].map(({ deviation, ofMiddle }) => `${mm(deviation)} (${mm(ofMiddle)})`);
        console.log(`| ${cells.join(' | ')} | ${(own.rate / other.rate).toFixed(2)} | ${apart.join(', ')} |`);
    });
}
