// wasi.js - the part of a system that rt205 needs: arguments, two streams, and files in memory.
//
// The calls are those of WASI preview 1 that the program imports. Each returns an error number. All
// paths start in a single root folder, /. Other folders exist while they contain a file. Source:
// the interface wasi_snapshot_preview1 (github.com/WebAssembly/WASI).

const errors = {
  none: 0, badFile: 8, exists: 20, invalid: 28, isFolder: 31, notFound: 44,
  unsupported: 52, notFolder: 54, notSeekable: 70,
};
const kinds = { unknown: 0, folder: 3, file: 4 };
const opening = { create: 1, folder: 2, exclusive: 4, truncate: 8 };
const root = 3; // descriptor of /; the streams have 0 to 2

/** The exit code of a program. It is thrown to end the program. */
export class Exit extends Error {
  constructor(code) {
    super(`exit ${code}`);
    this.code = code;
  }
}

const plain = (path) => {
  const names = [];
  for (const name of path.split("/")) {
    if (name === "..")
      names.pop();
    else if (name !== "" && name !== ".")
      names.push(name);
  }
  return names.join("/");
};

/** A file, which consists of bytes in a buffer that grows. */
class Bytes {
  constructor(bytes = new Uint8Array()) {
    this.buffer = bytes;
    this.length = bytes.length;
    this.written = false; // false while the bytes belong to the caller
  }
  get all() {
    return this.buffer.subarray(0, this.length);
  }
  resize(length) {
    if (length > this.buffer.length || !this.written) {
      const buffer = new Uint8Array(Math.max(length, 2 * this.buffer.length));
      buffer.set(this.all.subarray(0, buffer.length));
      this.buffer = buffer;
    }
    this.buffer.fill(0, Math.min(length, this.length), this.length);
    this.length = length;
    this.written = true;
  }
  put(at, bytes) {
    if (at + bytes.length > this.length || !this.written)
      this.resize(Math.max(at + bytes.length, this.length));
    this.buffer.set(bytes, at);
  }
}

/**
 * The imports of a program.
 * words: its name and arguments. files: its files, as bytes or text by path.
 * streams: functions that receive the bytes of stdout and stderr.
 * The caller must set .memory when the program has one. .written() returns the files
 * that the program wrote, by path.
 */
export class System {
  constructor(words, files, streams) {
    this.words = words.map((word) => new TextEncoder().encode(word + "\0"));
    this.files = new Map();
    for (const [path, text] of Object.entries(files))
      this.files.set(plain(path), new Bytes(typeof text === "string"
        ? new TextEncoder().encode(text) : text));
    this.open = [{ file: new Bytes(), at: 0 }, { put: streams.stdout },
      { put: streams.stderr }, { folder: "" }];
  }

  written() {
    const all = {};
    for (const [path, file] of this.files)
      if (file.written)
        all[path] = file.all.slice();
    return all;
  }

  // ---- The program's memory ----------------------------------------------

  get view() {
    return new DataView(this.memory.buffer);
  }
  bytes(at, length) {
    return new Uint8Array(this.memory.buffer, at, length);
  }
  text(at, length) {
    return new TextDecoder().decode(this.bytes(at, length));
  }
  number(at, value) {
    this.view.setUint32(at, value, true);
    return errors.none;
  }
  long(at, value) {
    this.view.setBigUint64(at, BigInt(value), true);
    return errors.none;
  }
  // Yields the pieces of memory from a list of addresses and lengths.
  *pieces(list, count) {
    for (let i = 0; i < count; i++)
      yield this.bytes(this.view.getUint32(list + 8 * i, true),
        this.view.getUint32(list + 8 * i + 4, true));
  }

  // ---- Paths and descriptors ---------------------------------------------

  isFolder(path) {
    return path === ""
      || [...this.files.keys()].some((name) => name.startsWith(path + "/"));
  }
  // Returns the names and kinds of the entries of a folder.
  entries(folder) {
    const before = folder === "" ? "" : folder + "/";
    const kindOf = new Map();
    for (const path of this.files.keys())
      if (path.startsWith(before)) {
        const [name, ...rest] = path.slice(before.length).split("/");
        kindOf.set(name, rest.length > 0 ? kinds.folder : kinds.file);
      }
    return [...kindOf];
  }
  pathAt(at, length) {
    return plain(this.text(at, length));
  }
  // Returns the bytes of an entry of a folder. They contain the number of the next entry.
  entry(next, name, kind) {
    const bytes = new TextEncoder().encode(name);
    const entry = new Uint8Array(24 + bytes.length);
    const view = new DataView(entry.buffer);
    view.setBigUint64(0, BigInt(next), true);
    view.setBigUint64(8, 1n, true); // inode: any number but 0
    view.setUint32(16, bytes.length, true);
    view.setUint8(20, kind);
    entry.set(bytes, 24);
    return entry;
  }
  status(to, kind, size, number) {
    this.bytes(to, 64).fill(0);
    this.long(to + 8, number);
    this.view.setUint8(to + 16, kind);
    return this.long(to + 32, size);
  }
  statusOf(to, path) {
    const file = this.files.get(path);
    if (file) // the number identifies the file
      return this.status(to, kinds.file, file.length,
        1 + [...this.files.values()].indexOf(file));
    return this.isFolder(path) ? this.status(to, kinds.folder, 0, 0)
      : errors.notFound;
  }
  openPath(path, how) {
    let file = this.files.get(path);
    if (file && how & opening.create && how & opening.exclusive)
      return errors.exists;
    if (!file && this.isFolder(path))
      return how & opening.create ? errors.isFolder : { folder: path };
    if (file && how & opening.folder)
      return errors.notFolder;
    if (!file) {
      if (!(how & opening.create)
        || !this.isFolder(path.split("/").slice(0, -1).join("/")))
        return errors.notFound;
      file = new Bytes();
      this.files.set(path, file);
    }
    if (how & opening.truncate || how & opening.create && file.length === 0)
      file.resize(0);
    return { file, path, at: 0 };
  }

  // ---- The calls ---------------------------------------------------------

  get calls() {
    const at = (number) => this.open[number];
    return {
      args_sizes_get: (count, size) => {
        this.number(count, this.words.length);
        return this.number(size, this.words.reduce(
          (sum, word) => sum + word.length, 0));
      },
      args_get: (list, to) => {
        for (const word of this.words) {
          this.number(list, to);
          this.bytes(to, word.length).set(word);
          list += 4;
          to += word.length;
        }
        return errors.none;
      },
      environ_sizes_get: (count, size) => {
        this.number(count, 0);
        return this.number(size, 0);
      },
      environ_get: () => errors.none,
      proc_exit: (code) => {
        throw new Exit(code);
      },
      poll_oneoff: () => errors.unsupported,

      fd_prestat_get: (number, to) => number !== root ? errors.badFile
        : (this.number(to, 0), this.number(to + 4, 1)),
      fd_prestat_dir_name: (number, to) => {
        this.bytes(to, 1)[0] = "/".charCodeAt(0);
        return errors.none;
      },
      fd_fdstat_get: (number, to) => {
        if (!at(number))
          return errors.badFile;
        this.bytes(to, 24).fill(0xff);
        this.number(to, at(number).folder !== undefined ? kinds.folder
          : at(number).file ? kinds.file : kinds.unknown);
        return errors.none;
      },
      fd_fdstat_set_flags: () => errors.none,
      fd_sync: () => errors.none,
      fd_renumber: () => errors.unsupported,
      fd_filestat_get: (number, to) => {
        const open = at(number);
        if (!open)
          return errors.badFile;
        return open.file && open.path !== undefined
          && this.files.get(open.path) === open.file
          || open.folder !== undefined
          ? this.statusOf(to, open.path ?? open.folder)
          : this.status(to, kinds.unknown, open.file?.length ?? 0, 0);
      },
      fd_filestat_set_size: (number, size) => {
        if (!at(number)?.file)
          return errors.badFile;
        at(number).file.resize(Number(size));
        return errors.none;
      },
      fd_close: (number) => {
        if (!at(number))
          return errors.badFile;
        this.open[number] = undefined;
        return errors.none;
      },
      fd_readdir: (number, to, room, from, used) => {
        const folder = at(number)?.folder;
        let filled = 0;
        if (folder === undefined)
          return errors.badFile;
        const entries = this.entries(folder);
        for (let i = Number(from); i < entries.length && filled < room; i++) {
          const entry = this.entry(i + 1, ...entries[i]).subarray(0, room - filled);
          this.bytes(to + filled, entry.length).set(entry);
          filled += entry.length;
        }
        return this.number(used, filled);
      },
      fd_read: (number, list, count, size) => {
        const open = at(number);
        let sum = 0;
        if (!open?.file)
          return open?.folder !== undefined ? errors.isFolder
            : errors.badFile;
        for (const piece of this.pieces(list, count)) {
          const some = open.file.all.subarray(open.at,
            open.at + piece.length);
          piece.set(some);
          open.at += some.length;
          sum += some.length;
        }
        return this.number(size, sum);
      },
      fd_write: (number, list, count, size) => {
        const open = at(number);
        let sum = 0;
        if (!open || open.folder !== undefined)
          return errors.badFile;
        for (const piece of this.pieces(list, count)) {
          if (open.put) {
            open.put(piece.slice());
          } else {
            open.file.put(open.at, piece);
            open.at += piece.length;
          }
          sum += piece.length;
        }
        return this.number(size, sum);
      },
      fd_seek: (number, by, from, to) => {
        const open = at(number);
        if (!open?.file)
          return open ? errors.notSeekable : errors.badFile;
        const place = [0, open.at, open.file.length][from] + Number(by);
        if (!(place >= 0))
          return errors.invalid;
        open.at = place;
        return this.long(to, place);
      },

      path_open: (folder, links, path, length, how, rights, inheriting,
        flags, to) => {
        const open = this.openPath(this.pathAt(path, length), how);
        if (typeof open === "number")
          return open;
        this.open.push(open);
        return this.number(to, this.open.length - 1);
      },
      path_filestat_get: (folder, links, path, length, to) =>
        this.statusOf(to, this.pathAt(path, length)),
      path_readlink: () => errors.invalid, // there are no links
      path_rename: (folder, from, length, other, to, toLength) => {
        const path = this.pathAt(from, length);
        const file = this.files.get(path);
        if (!file)
          return errors.notFound;
        this.files.delete(path);
        this.files.set(this.pathAt(to, toLength), file);
        return errors.none;
      },
      path_unlink_file: (folder, path, length) =>
        this.files.delete(this.pathAt(path, length)) ? errors.none
          : errors.notFound,
      path_remove_directory: () => errors.notFolder,
    };
  }
}
