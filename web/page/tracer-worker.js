// tracer-worker.js - runs rt205 in a worker, one run at a time, and posts the rows of the picture
// when they are finished. The page terminates the worker to stop a run.

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
