// tracer-worker.js - rt205 behind the page: a run at a time, with its picture while it
// grows.  Whoever wants a run to end ends the worker.

import { loadTracer } from "../tracer/tracer.js";

let tracer = null;

function work({ args, files }, run) {
  const printed = { stdout: "", stderr: "" };
  const ended = run(args, files, {
    stdout: (text) => { printed.stdout += text; },
    stderr: (text) => { printed.stderr += text; },
    progress: (done, all) => { postMessage({ part: done / all }); },
    rows: (view) => postMessage({ view }, [view.rgba.buffer]),
  });
  postMessage({ ended: { ...ended, ...printed } });
}

onmessage = async ({ data }) => {
  try {
    if (data.wasm) tracer = loadTracer(data.wasm);
    else work(data, await tracer);
  } catch (fault) {
    postMessage({ lost: String(fault?.message ?? fault) });
  }
};
