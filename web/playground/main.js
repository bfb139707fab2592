// The playground: scenes of Cairn in the browser, drawn by three.js.
import init, { CairnError, version } from 'cairn-physics';
import { Simulation } from './simulation.js';
import { Stage } from './stage.js';
import { Dragging } from './dragging.js';
import { KINDS, spawn } from './spawning.js';
import { fromFragment, toFragment } from './sharing.js';
import { describe } from './badge.js';

const $ = (id) => document.getElementById(id);
const stage = new Stage($('view'));
let simulation = null;
let playing = true;
let list = [];
let last = null,
    owed = 0,
    reported = 0; // time of the last report, and the simulated time that is still to be stepped

function tell(text) {
    $('message').textContent = text;
    $('message').hidden = text === '';
}

// An action of the user may be rejected; then the simulation is unchanged.
function attempt(action) {
    return async (...given) => {
        try {
            tell('');
            await action(...given);
        } catch (error) {
            if (!(error instanceof CairnError) && !(error instanceof TypeError)) throw error;
            tell(error.message);
        }
    };
}

function show(next) {
    const before = simulation;
    simulation = next;
    stage.show(next);
    dragging.end();
    before?.dispose();
    $('hint').textContent = next.hint;
    document.title = `${next.title} · Cairn playground`;
    if (list.some(({ name }) => name === next.name)) $('scenes').value = next.name;
    else $('scenes').selectedIndex = -1;
    setPlaying(true);
}

async function open(name) {
    const entry = list.find((scene) => scene.name === name);
    if (!entry) throw new TypeError(`there is no scene ${name}`);
    const response = await fetch(`scenes/${entry.file}`);
    if (!response.ok) throw new TypeError(`scenes/${entry.file}: cannot be read: status ${response.status}`);
    show(new Simulation(await response.text(), { name, hashes: entry.hashes }));
}

async function openFile(file) {
    show(new Simulation(new Uint8Array(await file.arrayBuffer()), { name: file.name }));
    history.replaceState(null, '', location.pathname);
}

async function openFragment() {
    const shared = await fromFragment(location.hash);
    if (shared?.scene) return open(shared.scene);
    if (shared?.gltf) return show(new Simulation(shared.gltf, { name: 'shared scene' }));
    return open('welcome');
}

function setPlaying(on) {
    playing = on;
    if (!on) owed = 0; // the time before a pause is not made up for
    $('play').textContent = on ? 'Pause' : 'Play';
}

const dragging = new Dragging(stage, () => simulation);

function report() {
    const { world } = simulation;
    const { bodies, awakeBodies, contacts, times } = world.statistics;
    $('numbers').textContent =
        `${bodies} bodies, ${awakeBodies} awake, ${contacts} contacts, ${times.total.toFixed(2)} ms per step`;
    const { state, html } = describe(simulation);
    if ($('badge').innerHTML !== html) $('badge').innerHTML = html;
    $('badge').dataset.state = state;
}

function frame(now) {
    const seconds = last === null ? 0 : Math.min((now - last) / 1000, 0.1);
    last = now;
    if (simulation) {
        if (playing) owed += seconds * Number($('speed').value);
        // On slow machines the simulation lags instead of accumulating a growing backlog.
        for (let steps = 0; owed >= simulation.world.timeStep && steps < 4; ++steps) {
            simulation.step();
            owed -= simulation.world.timeStep;
        }
        owed = Math.min(owed, simulation.world.timeStep);
        stage.draw();
        if (now - reported > 200) {
            reported = now;
            report();
        }
    }
    requestAnimationFrame(frame);
}

function bind() {
    $('play').onclick = () => setPlaying(!playing);
    $('step').onclick = () => {
        setPlaying(false);
        simulation.step();
    };
    $('reset').onclick = attempt(() => show(simulation.again()));
    $('spawn').onclick = attempt(() => {
        spawn(simulation, $('kind').value, stage.camera);
        stage.rebuild();
    });
    $('speed').oninput = () => ($('speed-text').textContent = $('speed').value);
    $('scenes').onchange = () => (location.hash = `scene=${$('scenes').value}`);
    $('share').onclick = attempt(async () => {
        history.replaceState(null, '', await toFragment(simulation));
        await navigator.clipboard?.writeText(location.href).catch(() => tell('The link is in the address bar.'));
    });
    $('file').onchange = attempt(async () => {
        const [file] = $('file').files;
        $('file').value = ''; // allows the same file to be chosen again
        if (file) await openFile(file);
    });
    addEventListener('hashchange', attempt(openFragment));
    addEventListener('dragover', (event) => event.preventDefault());
    addEventListener(
        'drop',
        attempt(async (event) => {
            event.preventDefault();
            const [file] = event.dataTransfer.files;
            if (file) await openFile(file);
        }),
    );
    const keys = { ' ': 'play', ArrowRight: 'step', r: 'reset', Delete: 'reset', b: 'spawn' };
    addEventListener('keydown', (event) => {
        if (!keys[event.key] || ['SELECT', 'INPUT', 'BUTTON'].includes(event.target.tagName)) return;
        event.preventDefault();
        $(keys[event.key]).click();
    });
}

await attempt(async () => {
    await init();
    list = await (await fetch('scenes/list.json')).json();
    $('scenes').append(...list.map(({ name, title }) => new Option(title, name)));
    $('kind').append(...KINDS.map((kind) => new Option(kind, kind)));
    bind();
    await openFragment();
    requestAnimationFrame(frame);
})();
// For tests, and for the browser's console.
globalThis.playground = {
    version,
    stage,
    get simulation() {
        return simulation;
    },
    setPlaying,
};
