// worker.js - the engine behind the page: takes requests in turn, continues with long
// ones in slices and looks at its messages in between, so that each can be stopped.  One
// that is only of use while nobody wants anything else ("idle") gives way to the next.

import { startEngine } from "./engine.js";

const SLICE = 40; // milliseconds
const waiting = [];
let engine = null;
let stopped = false;

// What has to wait for messages waits for one of its own, behind them.
const turn = new MessageChannel();
let goOn = null;
turn.port1.onmessage = () => goOn();
const pause = () => new Promise((resolve) => { goOn = resolve; turn.port2.postMessage(0); });

async function answer({ id, request }) {
  stopped = false;
  for (let first = true; ; first = false) {
    const reply = engine.answer(first ? { ms: SLICE, ...request } : { do: "more", ms: SLICE });
    if (reply.done !== false || stopped || (request.idle && waiting.length > 1)) {
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
