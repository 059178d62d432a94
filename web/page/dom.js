// dom.js - finds, creates and fills elements of the page; formats numbers; stores values.

export const $ = (id) => document.getElementById(id);

const present = (children) => children.flat(Infinity).filter((child) => child != null && child !== false);

function setUp(node, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") node.addEventListener(name, value);
    else if (value === true) node.setAttribute(name, "");
    else if (value !== false && value != null) node.setAttribute(name, value);
  }
  node.append(...present(children));
  return node;
}

/** Replaces the children of a node. */
export function fill(node, ...children) {
  node.replaceChildren(...present(children));
}

/** Creates an element. An attribute whose value is a function becomes an event listener. Children
 * that are null or false are skipped. */
export function el(name, attributes = {}, ...children) {
  return setUp(document.createElement(name), attributes, children);
}

/** Creates an SVG element. Attributes and children are as in el. */
export function draw(name, attributes = {}, ...children) {
  return setUp(document.createElementNS("http://www.w3.org/2000/svg", name), attributes, children);
}

export function icon(name) {
  return draw("svg", { "aria-hidden": "true" }, draw("use", { href: `#icon-${name}` }));
}

/** Returns the heading of a panel. The elements of `aside` are at its right. */
export function heading(panel, title, ...aside) {
  return el("div", { class: "heading" },
    el("h2", { id: `${panel}-heading` }, title), el("div", { class: "aside" }, ...aside));
}

/** Returns a table. columns: [title, class]; rows: {cells}, whose cells are texts or elements. */
export function table(caption, columns, rows) {
  return el("table", {},
    el("caption", { class: "visually-hidden" }, caption),
    el("thead", {}, el("tr", {},
      columns.map(([title, kind]) => el("th", { scope: "col", class: kind }, title)))),
    el("tbody", {}, rows.map(({ cells, ...attributes }) => el("tr", attributes,
      cells.map((cell, i) => i === 0
        ? el("th", { scope: "row", class: columns[0][1] }, cell)
        : el("td", { class: columns[i][1] }, cell))))));
}

/** Fills a select with choices: {value, title}, or {group, choices}. The selected value remains
 * selected if the list contains it. */
export function choices(select, list) {
  const before = select.value;
  const option = ({ value, title }) => el("option", { value }, title);
  fill(select, list.map((entry) => entry.choices
    ? el("optgroup", { label: entry.group }, entry.choices.map(option))
    : option(entry)));
  if ([...select.options].some(({ value }) => value === before)) select.value = before;
}

export const count = (n) => n.toLocaleString("en");
// Rounds like printf. toLocaleString alone would round the shortest decimal form of the number.
export const fixed = (x, places, signed = false) => Number.isFinite(x)
  ? Number(x.toFixed(places)).toLocaleString("en", { minimumFractionDigits: places,
    maximumFractionDigits: places, signDisplay: signed ? "always" : "negative" })
  : "-";
/** Returns a number with its noun, as in "1 clock" or "2 clocks". */
export const some = (n, what) => `${count(n)} ${what}${n === 1 ? "" : "s"}`;
/** Formats a time in µs, ms or s, with two decimals. */
export function duration(microseconds) {
  const [unit, by] = microseconds < 1000 ? ["µs", 1] : microseconds < 1e6 ? ["ms", 1e3] : ["s", 1e6];
  return `${fixed(microseconds / by, 2)} ${unit}`;
}

/** Returns the CSS class for the colour of a cause. Only letters count, and case does not matter, so
 * "vector start-up" and vector_startup have the same class. */
export const colour = (cause) => `cause-${cause.toLowerCase().replace(/[^a-z]/g, "")}`;

const lost = new Map(); // reasons for which values could not be stored, by name

function report() {
  const [why] = lost.values();
  $("unstored").hidden = !why;
  $("unstored").textContent = why ? `${why} Your text is lost when this page is closed: copy it, or use Share.` : "";
}

/** Values that are stored between visits. The page reports a value that cannot be stored. A stored
 * value may have any type, because other versions of the page, and other pages of the same origin,
 * write to the same storage. */
export const storage = {
  get(name) {
    try { return JSON.parse(localStorage.getItem(`c205.${name}`)); } catch { return null; }
  },
  /** Returns the value if it is a text, and null otherwise. */
  text(name) {
    const value = storage.get(name);
    return typeof value === "string" ? value : null;
  },
  set(name, value) {
    try {
      localStorage.setItem(`c205.${name}`, JSON.stringify(value));
      lost.delete(name);
    } catch (fault) {
      lost.set(name, /quota/i.test(fault.name) ? "The storage of this browser is full."
        : "This browser stores no data for this page.");
    }
    report();
  },
};
