// engine.js - runs the engine in a worker, a page or node. Requests and replies are objects
// (web/engine/engine.h).

const SUCCESS = 0, NO_FILE = 8; // errno values of WASI: success, and ebadf

// The functions that the module imports: a clock, and a write function that passes its text to
// COMPLAIN. The module prints only if it fails. All other functions on files fail.
function imports(memory, complain) {
  const view = () => new DataView(memory().buffer);
  const noFile = () => NO_FILE;

  function clock_time_get(_clock, _precision, time) {
    view().setBigUint64(time, BigInt(Math.round(performance.now() * 1e6)), true);
    return SUCCESS;
  }

  function fd_write(_file, parts, count, written) {
    let length = 0;
    for (let i = 0; i < count; i++) {
      const at = view().getUint32(parts + 8 * i, true);
      const size = view().getUint32(parts + 8 * i + 4, true);
      complain(new TextDecoder().decode(new Uint8Array(memory().buffer, at, size)));
      length += size;
    }
    view().setUint32(written, length, true);
    return SUCCESS;
  }

  function proc_exit(code) {
    throw new Error(`the engine has ended with ${code}`);
  }

  return {
    clock_time_get, fd_write, proc_exit,
    fd_close: noFile, fd_fdstat_get: noFile, fd_fdstat_set_flags: noFile,
    fd_filestat_get: noFile, fd_prestat_get: noFile, fd_prestat_dir_name: noFile, fd_read: noFile,
    fd_seek: noFile, fd_sync: noFile,
    path_filestat_get: noFile, path_open: noFile, path_rename: noFile, path_unlink_file: noFile,
  };
}

/** Starts an engine from the bytes of engine.wasm or from a compiled module. */
export async function startEngine(wasm, complain = (text) => console.error(text)) {
  const module = wasm instanceof WebAssembly.Module ? wasm : await WebAssembly.compile(wasm);
  const instance = await WebAssembly.instantiate(module, {
    wasi_snapshot_preview1: imports(() => instance.exports.memory, complain),
  });
  const { memory, room, answer, free, _initialize } = instance.exports;
  const encoder = new TextEncoder(), decoder = new TextDecoder();
  _initialize();

  /** Sends a request as JSON text and returns the reply as text. */
  function answerText(text) {
    const request = encoder.encode(text);
    const at = room(request.length);
    if (at === 0) throw new Error("the engine is out of memory");
    new Uint8Array(memory.buffer, at, request.length).set(request);
    const reply = answer(at, request.length);
    if (reply === 0) throw new Error("the engine is out of memory");
    const bytes = new Uint8Array(memory.buffer, reply);
    const words = decoder.decode(bytes.subarray(0, bytes.indexOf(0)));
    free(reply);
    return words;
  }

  return {
    answerText,
    answer: (request) => JSON.parse(answerText(JSON.stringify(request))),
    /** Returns the size of the engine's memory in bytes. */
    size: () => memory.buffer.byteLength,
  };
}
