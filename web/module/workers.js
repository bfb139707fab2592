// Put before the loader that Emscripten makes for cairn-physics/mt. What it knows as `Worker` and `postMessage` is what
// web/src/mt gives it: those of browsers or of Node.
var Worker = Module['Worker'],
    postMessage = Module['postMessage'];
