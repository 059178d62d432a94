// worker.js - runs the engine in a worker. It answers requests one at a time, in slices, and reads
// messages between slices, so a request can be stopped. A request marked "idle" is stopped by a
// request that is not, and by a later request with the same name.

import { startEngine } from "./engine.js";

const SLICE = 40; // milliseconds
const waiting = [];
let engine = null;
let stopped = false;

// pause() lets the worker receive pending messages. It posts a message to itself, which arrives
// after them.
const turn = new MessageChannel();
let resume = null;
turn.port1.onmessage = () => resume();
const pause = () => new Promise((resolve) => { resume = resolve; turn.port2.postMessage(0); });

const yields = (request) => request.idle
  && waiting.slice(1).some(({ request: next }) => !next.idle || next.do === request.do);

async function answer({ id, request }) {
  stopped = false;
  for (let first = true; ; first = false) {
    const reply = engine.answer(first ? { ms: SLICE, ...request } : { do: "more", ms: SLICE });
    if (reply.done !== false || stopped || yields(request)) {
      postMessage({ id, reply: reply.done === false ? { ...reply, stopped: true } : reply });
      return;
    }
    postMessage({ id, progress: reply });
    await pause();
  }
}

async function work() {
  while (waiting.length > 0) {
    const next = waiting[0];
    try {
      await answer(next);
    } catch (fault) {
      postMessage({ id: next.id, lost: String(fault?.message ?? fault) });
    }
    waiting.shift();
  }
}

onmessage = async ({ data }) => {
  if (data.wasm) {
    try {
      engine = await startEngine(data.wasm);
      postMessage({ ready: true });
    } catch (fault) {
      postMessage({ failed: String(fault?.message ?? fault) });
    }
  } else if (data.stop) {
    stopped = true;
  } else {
    waiting.push(data);
    if (waiting.length === 1) work();
  }
};
