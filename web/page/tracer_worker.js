// tracer_worker.js - rt205 behind the page: runs it once for each message, and tells of
// the picture on the way.  What loops is ended with the worker.

import { loadTracer } from "../tracer/tracer.js";

let tracer = null;

onmessage = async ({ data: { wasm, args, files } }) => {
  try {
    tracer ??= await loadTracer(wasm);
    const text = (part) => postMessage({ text: part });
    const { code } = tracer(args, files, {
      stdout: text, stderr: text,
      progress: (done, all) => { postMessage({ done, all }); },
      rows: (rows) => postMessage({ rows }, [rows.rgba.buffer]),
    });
    postMessage({ code });
  } catch (fault) {
    postMessage({ text: `the tracer has failed: ${fault.message}\n`, code: 1 });
  }
};
