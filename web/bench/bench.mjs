// Compares the npm package with the other engines on npm, in Node, in alternating rounds.
import { cpus } from 'node:os';
import { parseArgs } from 'node:util';
import { ENGINES } from './engines.mjs';
import { gap, isLost, overlap } from './quality.mjs';
import { SCENES } from './scenes.mjs';

const USAGE = `usage: ./dev bench --web [--scenes NAME,...] [--engines NAME,...] [--steps N] [--rounds N] [--seconds N]
  --scenes    of ${Object.keys(SCENES).join(', ')} (all)
  --engines   of ${Object.keys(ENGINES).join(', ')} (all)
  --steps     of 1/60 s (300)
  --rounds    of which the median is taken (3)
  --seconds   after which a run ends early, and is not repeated (40)
Prints ms of the processor a step, and of the state at the end the overlap below which 99 % of the touching pairs are,
or the mean gap of its joints.`;

function options() {
    try {
        const { values } = parseArgs({
            options: {
                scenes: { type: 'string' },
                engines: { type: 'string' },
                steps: { type: 'string', default: '300' },
                rounds: { type: 'string', default: '3' },
                seconds: { type: 'string', default: '40' },
                help: { type: 'boolean' },
            },
        });
        if (values.help) {
            console.log(USAGE);
            process.exit(0);
        }
        const chosen = (text, all) => {
            const names = text?.split(',') ?? Object.keys(all);
            for (const name of names)
                if (!all[name]) throw new TypeError(`there is no ${name}, only ${Object.keys(all).join(', ')}`);
            return names;
        };
        const number = (name) => {
            const value = Number(values[name]);
            if (!Number.isInteger(value) || value < 1 || value > 100000)
                throw new TypeError(`--${name} ${values[name]}: must be a whole number from 1 to 100000`);
            return value;
        };
        return {
            scenes: chosen(values.scenes, SCENES),
            engines: chosen(values.engines, ENGINES),
            steps: number('steps'),
            rounds: number('rounds'),
            seconds: number('seconds'),
        };
    } catch (error) {
        console.error(`bench: ${error.message}\n${USAGE}`);
        process.exit(2);
    }
}

/**
 * One run: milliseconds per step, the number of steps, and the quality of the final state. The time is processor time,
 * on which other programs have less influence; all engines use one thread.
 */
function measure(engine, scene, steps, seconds) {
    const world = engine.make(scene);
    const begin = performance.now();
    const before = process.cpuUsage();
    let done = 0;
    while (done < steps && performance.now() - begin < 1000 * seconds) {
        world.step();
        ++done;
    }
    const { user, system } = process.cpuUsage(before);
    const poses = world.poses();
    const lost = isLost(poses);
    world.end();
    return {
        ms: (user + system) / 1000 / done,
        done,
        lost,
        overlap: lost ? null : overlap(scene, poses),
        gap: lost ? null : gap(scene, poses),
    };
}

const median = (list) => [...list].sort((a, b) => a - b)[list.length >> 1];
const millimeters = (meters) => (meters === null ? '' : `${(1000 * meters).toPrecision(2)}`);

const { scenes, engines, steps, rounds, seconds } = options();
if (!engines.includes('cairn')) await ENGINES.cairn(); // needed for measuring the overlaps
const loaded = [];
for (const name of engines) loaded.push(await ENGINES[name]());
console.log(`Node ${process.version}, ${cpus()[0].model}, ${steps} steps, median of ${rounds} rounds by turns\n`);
console.log(
    '| scene | engine | ms a step | of the fastest other | 99 % of overlaps below, mm | mean gap of joints, mm |',
);
console.log('|---|---|---|---|---|---|');
for (const name of scenes) {
    const scene = SCENES[name]();
    const runs = loaded.map(() => []);
    // Warm-up, which is not measured: lets Node's optimizing compiler finish.
    for (const engine of loaded) measure(engine, scene, Math.min(steps, 100), seconds / 4);
    for (let round = 0; round < rounds; ++round) {
        loaded.forEach((engine, i) => {
            // An engine that exceeded the time limit in a round is not measured again.
            if (runs[i].some((run) => run.done < steps)) return;
            runs[i].push(measure(engine, scene, steps, seconds));
            console.error(`${name}, round ${round + 1}, ${engine.name}: ${runs[i].at(-1).ms.toFixed(2)} ms`);
        });
    }
    const times = runs.map((list) => median(list.map(({ ms }) => ms)));
    loaded.forEach((engine, i) => {
        const { done, lost, overlap: depth, gap: apart } = runs[i].at(-1);
        const others = Math.min(...times.filter((_, k) => k !== i));
        const note = (done < steps ? ` (${done} steps)` : '') + (lost ? ' (it lost bodies)' : '');
        const ratio = Number.isFinite(others) ? (times[i] / others).toFixed(2) : '';
        const quality = [millimeters(depth), millimeters(apart)];
        const cells = [name, engine.name + note, times[i].toPrecision(3), ratio, ...quality];
        console.log(`| ${cells.join(' | ')} |`);
    });
}
