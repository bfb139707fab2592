// A library for Emscripten's linker. Its own function warns on the console when the main thread of a page waits, as it
// does when World.threads changes or a world is disposed of: until threads that have nothing to do have ended.
mergeInto(LibraryManager.library, { emscripten_check_blocking_allowed: function () {} });
