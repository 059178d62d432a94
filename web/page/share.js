// share.js - a link that holds all: behind its # the program (deflated), the model,
// the pages, the lesson.  Nothing of it goes to any server.

const MOST = 1 << 20; // bytes of a program: a link may hold very many that are packed well

async function through(stream, bytes, most = Infinity) {
  const reader = new Blob([bytes]).stream().pipeThrough(stream).getReader();
  const parts = [];
  let length = 0;
  for (let part = await reader.read(); !part.done; part = await reader.read()) {
    parts.push(part.value);
    length += part.value.length;
    if (length > most) {
      await reader.cancel();
      throw new Error("it is too long");
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

/** The # part for {text, model, warm, lesson}. */
export async function toHash({ text, model, warm, lesson }) {
  const packed = await through(new CompressionStream("deflate-raw"), new TextEncoder().encode(text));
  const words = new URLSearchParams({ ...(lesson && { lesson }), model, ...(warm && { pages: warm }),
    program: toText(packed) });
  return `#${words}`;
}

/** What a # part holds; null: nothing of ours; throws: it is spoilt. */
export async function fromHash(hash) {
  const words = new URLSearchParams(hash.slice(1));
  const shared = { lesson: words.get("lesson"), model: words.get("model"),
    warm: words.get("pages") ?? "" };
  const packed = words.get("program");
  if (packed === null) return shared.lesson ? shared : null;
  const bytes = await through(new DecompressionStream("deflate-raw"), toBytes(packed), MOST);
  return { ...shared, text: new TextDecoder().decode(bytes) };
}
