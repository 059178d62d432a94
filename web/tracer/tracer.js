// tracer.js - runs rt205 as a function. It takes arguments and files, and returns the exit code and
// files. Text and rows of the picture are passed on while it runs.
//
// It works in node and in a worker of the page. A worker must be terminated to stop a program that
// does not end.
import { Exit, System } from "./wasi.js";

const VIEW_INTERVAL = 100; // milliseconds between two views of a growing picture

/**
 * Compiles the bytes of rt205.wasm and returns the function
 *
 *   run(args, files, on) -> { code, files }
 *
 * args: arguments of the command, such as ["render", "a.pov", "-o", "a.png"].
 * files: { path: text or bytes }, the only files that the program can read.
 * on.stdout(text), on.stderr(text): called when the program writes.
 * on.progress(done, all): called from time to time; false stops the work.
 * on.rows({ width, height, first, rows, rgba, clocks, seconds, causes }): rows of a
 *   picture from `first` on, as in the machine's memory, and its clocks so far.
 * code: the exit code; files: the files that the program wrote, as bytes.
 */
export async function loadTracer(bytes) {
  const module = await WebAssembly.compile(bytes);
  return (args, files = {}, on = {}) => run(module, args, files, on);
}

function run(module, args, files, on) {
  const stream = (take) => {
    const decoder = new TextDecoder();
    return (bytes) => take?.(decoder.decode(bytes, { stream: true }));
  };
  const system = new System(["rt205", ...args], files,
    { stdout: stream(on.stdout), stderr: stream(on.stderr) });
  const instance = new WebAssembly.Instance(module, {
    wasi_snapshot_preview1: system.calls,
    rt205: watching(system, on),
  });
  system.memory = instance.exports.memory;
  try {
    instance.exports._start();
  } catch (end) {
    if (!(end instanceof Exit))
      throw end;
    return { code: end.code, files: system.written() };
  }
  return { code: 0, files: system.written() };
}

// Returns the imports of web/tracer/platform/watch.c.
function watching(system, on) {
  let shown = performance.now();
  return {
    progress: (done, all) => on.progress?.(done, all) !== false,
    wants_rows: (done) => on.rows !== undefined
      && (done || performance.now() - shown >= VIEW_INTERVAL),
    rows: (width, height, first, rows, rgba, clocks, length) => {
      on.rows({
        width, height, first, rows,
        rgba: Uint8ClampedArray.from(system.bytes(rgba, 4 * width * rows)),
        ...JSON.parse(system.text(clocks, length)),
      });
      shown = performance.now();
    },
  };
}
