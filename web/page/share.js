// share.js - a link that contains the program (deflated), the model, the state of the pages and the
// lesson. They are in the fragment, after #, which browsers do not send to a server.

import { count } from "./dom.js";

/** Limits, which are checked when a link is made and when it is opened. MAX_PROGRAM is the bytes of
 * a program, because a short link may unpack to a large program. MAX_LINK is the characters of a
 * link that every browser opens. */
export const MAX_PROGRAM = 1 << 20;
const MAX_LINK = 1 << 19;

const tooLong = (limit, what) => new RangeError(`is too long for a link: the limit is ${count(limit)} ${what}.`);

async function through(stream, bytes, limit = Infinity) {
  const reader = new Blob([bytes]).stream().pipeThrough(stream).getReader();
  const parts = [];
  let length = 0;
  for (let part = await reader.read(); !part.done; part = await reader.read()) {
    parts.push(part.value);
    length += part.value.length;
    if (length > limit) {
      await reader.cancel();
      throw tooLong(limit, "bytes");
    }
  }
  return new Uint8Array(await new Blob(parts).arrayBuffer());
}

function toText(bytes) {
  let binary = "";
  for (const byte of bytes) binary += String.fromCharCode(byte);
  return btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

const toBytes = (text) => Uint8Array.from(
  atob(text.replaceAll("-", "+").replaceAll("_", "/")), (letter) => letter.charCodeAt(0));

function check(length, limit, what) {
  if (length > limit) throw tooLong(limit, what);
}

/** Returns the fragment for {text, model, warm, lesson}. Throws a RangeError if it is too long. */
export async function toHash({ text, model, warm, lesson }) {
  const bytes = new TextEncoder().encode(text);
  check(bytes.length, MAX_PROGRAM, "bytes");
  const packed = await through(new CompressionStream("deflate-raw"), bytes);
  const words = new URLSearchParams({ ...(lesson && { lesson }), model, ...(warm && { pages: warm }),
    program: toText(packed) });
  const hash = `#${words}`;
  check(hash.length, MAX_LINK, "characters in the link");
  return hash;
}

/** Returns the contents of a fragment, or null if it has neither program nor lesson. Throws a
 * RangeError if it is too long, and another error if it is damaged. */
export async function fromHash(hash) {
  check(hash.length, MAX_LINK, "characters in the link");
  const words = new URLSearchParams(hash.slice(1));
  const shared = { lesson: words.get("lesson"), model: words.get("model"),
    warm: words.get("pages") ?? "" };
  const packed = words.get("program");
  if (packed === null) return shared.lesson ? shared : null;
  const bytes = await through(new DecompressionStream("deflate-raw"), toBytes(packed), MAX_PROGRAM);
  return { ...shared, text: new TextDecoder().decode(bytes) };
}
