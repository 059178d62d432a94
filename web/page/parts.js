// parts.js - the data of the page without its script. They are packed into the page, or are files
// in the folder of the site.

import worker from "c205:worker"; // the build bundles it
import tracerWorker from "c205:tracer-worker";

export const workerSource = () => worker;
export const tracerSource = () => tracerWorker;

async function part(id, file) {
  const inlined = document.getElementById(id);
  if (!inlined) return fetch(file);
  const packed = Uint8Array.from(atob(inlined.textContent), (letter) => letter.charCodeAt(0));
  return new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip")));
}

/** Functions that return promises: the bytes of the engine and of the tracer, the scenes, the
 * lessons with their examples, and the notices of third-party code. */
export const engineBytes = async () => (await part("engine", "engine.wasm")).arrayBuffer();
export const tracerBytes = async () => (await part("rt205", "rt205.wasm")).arrayBuffer();
export const scenes = async () => (await part("scenes", "scenes.json")).json();
export const course = async () => (await part("course", "course.json")).json();
export const notice = async () => (await part("notice", "NOTICE.md")).text();
