// machine.js - sends requests to the engine in the worker. It starts a new engine if the old engine
// does not answer.

// Milliseconds between a stop and the end of the worker. GRADE_STOP_TIMEOUT applies to a request
// that the engine cannot interrupt.
const STOP_TIMEOUT = 3000, GRADE_STOP_TIMEOUT = 250;

export class Machine {
  #source; #wasm; #worker; #ready;
  #pending = new Map();
  #next = 1;
  #watch = 0;

  /** True after an engine was lost with its program. */
  lost = false;

  /** SOURCE is the text of the worker. WASM is a promise of the bytes of the engine. */
  constructor(source, wasm) {
    this.#source = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
    this.#wasm = wasm;
    this.#start();
  }

  #start() {
    const worker = new Worker(this.#source);
    this.#worker = worker;
    this.#ready = new Promise((resolve, reject) => {
      worker.onmessage = ({ data }) => {
        if (data.ready) resolve();
        else if (data.failed) reject(new Error(data.failed));
        else this.#receive(data);
      };
      worker.onerror = (event) => { reject(new Error(event.message)); this.#lose(event.message); };
    });
    this.#wasm.then((wasm) => worker.postMessage({ wasm }));
  }

  #receive({ id, reply, progress, lost }) {
    const pending = this.#pending.get(id);
    if (!pending) return;
    if (progress) return void pending.progress?.(progress);
    this.#pending.delete(id);
    clearTimeout(this.#watch);
    if (lost === undefined) return pending.resolve(reply);
    pending.resolve({ ok: false, error: `The engine has failed: ${lost}.` });
    this.#lose("it was started again");
  }

  // Starts a new worker, which has no program. Pending requests to the old worker fail.
  #lose(why, stopped = false) {
    this.lost = true;
    this.#worker.terminate();
    for (const { resolve } of this.#pending.values())
      resolve({ ok: false, stopped, error: `The engine has stopped: ${why}.` });
    this.#pending.clear();
    this.#start();
  }

  /** Returns the reply of the engine. PROGRESS receives reports if the request takes more than a
   * slice. */
  async request(message, progress) {
    await this.#ready;
    return new Promise((resolve) => {
      const id = this.#next++;
      this.#pending.set(id, { resolve, progress, uninterruptible: message.do === "grade" });
      this.#worker.postMessage({ id, request: message });
    });
  }

  /** True if no request is pending. */
  get idle() {
    return this.#pending.size === 0;
  }

  /** Stops the current request. Its reply contains the result so far. */
  stop() {
    this.#worker.postMessage({ stop: true });
    clearTimeout(this.#watch);
    if (this.#pending.size === 0) return;
    const uninterruptible = [...this.#pending.values()].some((one) => one.uninterruptible);
    this.#watch = setTimeout(() => this.#lose("it did not answer in time", uninterruptible),
      uninterruptible ? GRADE_STOP_TIMEOUT : STOP_TIMEOUT);
  }
}
