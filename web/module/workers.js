// Put before the loader that Emscripten makes for cairn-physics/mt. What it knows as `Worker` and `postMessage` are what
// web/src/mt gives it, which are those of browsers or of Node.
var Worker = Module['Worker'],
    postMessage = Module['postMessage'];
