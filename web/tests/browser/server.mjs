// server.mjs - serves the folder of the site on the local host.

import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";

const TYPES = { ".html": "text/html; charset=utf-8", ".css": "text/css", ".js": "text/javascript",
  ".wasm": "application/wasm", ".json": "application/json", ".md": "text/markdown" };
// The strictest policy under which the page works. It forbids data of other origins and eval.
const POLICY = ["default-src 'none'", "script-src 'self' 'wasm-unsafe-eval'", "worker-src blob:",
  "style-src 'self' 'unsafe-inline'", "img-src data: blob:", "connect-src 'self'", "base-uri 'none'",
  "form-action 'none'"].join("; ");

/** Starts the server. Returns {address, requested, end}; requested contains the paths requested so
 * far. */
export async function serve(folder) {
  const requested = [];
  const server = createServer(async ({ url }, response) => {
    const path = normalize(decodeURIComponent(new URL(url, "http://localhost").pathname));
    requested.push(path);
    try {
      const bytes = await readFile(join(folder, path.endsWith("/") ? `${path}index.html` : path));
      response.writeHead(200, { "content-type": TYPES[extname(path)] ?? TYPES[".html"],
        "content-security-policy": POLICY }).end(bytes);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((resolve) => { server.listen(0, "127.0.0.1", resolve); });
  return {
    address: `http://127.0.0.1:${server.address().port}/`, requested,
    end: () => new Promise((resolve) => { server.close(resolve); server.closeAllConnections(); }),
  };
}
