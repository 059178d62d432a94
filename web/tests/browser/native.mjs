// native.mjs - runs the native c205 and rt205, for comparisons with the page.

import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const root = join(dirname(fileURLToPath(import.meta.url)), "../../..");

export class Native {
  #folder = mkdtempSync(join(tmpdir(), "c205-native-"));

  constructor(build) {
    this.build = build;
    process.on("exit", () => rmSync(this.#folder, { recursive: true, force: true }));
  }

  /** Runs a command in a folder with FILES. Returns {status, out, err}, where out and err are
   * texts. */
  run(command, args, files = {}) {
    for (const [name, text] of Object.entries(files)) writeFileSync(join(this.#folder, name), text);
    const { status, stdout, stderr } = spawnSync(join(this.build, command), args,
      { cwd: this.#folder, encoding: "utf8", maxBuffer: 1 << 28 });
    return { status, out: stdout, err: stderr };
  }

  c205(args, files) {
    return this.run("c205", args, files);
  }

  rt205(args, files) {
    return this.run("rt205", args, files);
  }

  json(args, files) {
    const { status } = this.c205([...args, "--json", "out.json"], files);
    return { status, ...JSON.parse(readFileSync(join(this.#folder, "out.json"), "utf8")) };
  }

  /** The lessons with their starting texts and solutions. */
  get lessons() {
    const course = join(root, "docs/course");
    return readdirSync(course).filter((name) => /^\d\d-/.test(name)).sort().map((folder) => {
      const read = (name) => readFileSync(join(course, folder, name), "utf8");
      return { name: folder.slice(3), start: read("start.s"), solution: read("solution.s") };
    });
  }
}
