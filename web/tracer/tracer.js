// tracer.js - rt205 as a function: arguments and files in; exit code, files, and on
// the way text and rows of the picture out.
//
// For node and for a worker of the page; a program that loops is ended by ending its worker.
import { Exit, System } from "./wasi.js";

const between = 100; // ms from one view of a picture that grows to the next

/**
 * Compiles the program: rt205.wasm's bytes.  What it gives is
 *
 *   run(args, files, on) -> { code, files }
 *
 * args: those of the command, as ["render", "a.pov", "-o", "a.png"].
 * files: { path: text or bytes }, all that the program finds.
 * on.stdout(text), on.stderr(text): as the program writes them.
 * on.progress(done, all): now and then; false stops the work.
 * on.rows({ width, height, first, rows, rgba, clocks, seconds, causes }): rows of a
 *   picture from the first on, as they stand in the machine's memory, and its clocks so far.
 * code: what the program ends with; files: those that it wrote, as bytes.
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

// What web/tracer/platform/watch.c asks of the page.
function watching(system, on) {
  let shown = performance.now();
  return {
    progress: (done, all) => on.progress?.(done, all) !== false,
    wants_rows: (done) => on.rows !== undefined
      && (done || performance.now() - shown >= between),
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
