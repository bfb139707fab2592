// Exports of both entries of the package, index.js and mt.js, in addition to `init`.
export { ALL_LAYERS } from './memory.js';
export { CairnError } from './error.js';
export { Geometry } from './geometry.js';
export { Body, Snapshot, World, springFromFrequency } from './world.js';
export { version } from './load.js';
