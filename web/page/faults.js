// faults.js - lists of errors and warnings. A fault is {severity, file, line, column, message}.

import { el } from "./dom.js";

/** Returns the item of a list. NAME is the file whose lines are links; TOLINE goes to one. */
export const faultItem = ({ severity, file, line, column, message }, name, toLine) => el("li", { class: severity },
  file === name && line > 0
    ? el("button", { type: "button", click: () => toLine(line, column) }, `line ${line}`)
    : ` ${line > 0 ? `${file}:${line}` : file}`, " ", message);

/** Returns the first line of a fault as a sentence with its place. */
export function faultSentence({ file, line, message }, name) {
  const [first] = message.split("\n");
  const place = file === name ? `Line ${line}` : `${file}:${line}`;
  return `${line > 0 ? `${place}: ` : ""}${first.replace(/\.?$/, ".")}`;
}
