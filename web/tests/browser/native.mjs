// native.mjs - c205 itself, for what the page is held beside.

import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const root = join(dirname(fileURLToPath(import.meta.url)), "../../..");

export class Native {
  #folder = mkdtempSync(join(tmpdir(), "c205-native-"));

  constructor(build) {
    this.command = join(build, "c205");
  }

  /** {status, out}; what stands in FILES is there for the command. */
  c205(args, files = {}) {
    for (const [name, text] of Object.entries(files)) writeFileSync(join(this.#folder, name), text);
    const { status, stdout, stderr } = spawnSync(this.command, args,
      { cwd: this.#folder, encoding: "utf8", maxBuffer: 1 << 28 });
    return { status, out: stdout, told: stderr };
  }

  json(args, files) {
    const { status } = this.c205([...args, "--json", "out.json"], files);
    return { status, ...JSON.parse(readFileSync(join(this.#folder, "out.json"), "utf8")) };
  }

  /** Lessons with what stands in their folders. */
  get lessons() {
    const course = join(root, "docs/course");
    return readdirSync(course).filter((name) => /^\d\d-/.test(name)).sort().map((folder) => {
      const read = (name) => readFileSync(join(course, folder, name), "utf8");
      return { name: folder.slice(3), start: read("start.s"), solution: read("solution.s") };
    });
  }
}
