// editor.js - the text of the program: CodeMirror with highlighting for the assembler, breakpoints
// in the gutter, a mark at the current line, and errors at their positions.

import { defaultKeymap, history, historyKeymap, indentMore } from "@codemirror/commands";
import { HighlightStyle, StreamLanguage, bracketMatching, syntaxHighlighting }
  from "@codemirror/language";
import { setDiagnostics } from "@codemirror/lint";
import { EditorState, RangeSet, StateEffect, StateField } from "@codemirror/state";
import { Decoration, EditorView, GutterMarker, drawSelection, gutter, highlightActiveLine,
  hoverTooltip, keymap, lineNumbers } from "@codemirror/view";
import { tags } from "@lezer/highlight";
import { count, el, fixed, some } from "./dom.js";
import { MAX_PROGRAM } from "./share.js";

const TAB = 8;
const MARGIN = 2; // visible lines above and below the current line

// --- Language --------------------------------------------------------------

const NAME = /^[A-Za-z_$][\w$.]*/;

// A line is a statement: labels, the operation, operands and a comment.
function language(about) {
  const mnemonics = new Set(about.instructions.map((row) => row.mnemonic.toUpperCase()));
  const directives = new Set(about.directives.map((name) => name.toLowerCase()));
  const operation = (word) => mnemonics.has(word.replace(/,h$/i, "").toUpperCase())
    ? "keyword" : "macroName";

  return StreamLanguage.define({
    name: "c205",
    startState: () => ({ operands: false }),
    token(stream, state) {
      if (stream.sol()) state.operands = false;
      if (stream.eatSpace()) return null;
      if (stream.match(/^;\s*(expect|test|goals|tolerance)\b.*/)) return "docComment";
      if (stream.match(/^;.*/)) return "lineComment";
      if (stream.match(/^"(\\.|[^"\\])*"?/)) return "string";
      if (!state.operands) {
        if (stream.match(/^[A-Za-z_$][\w$.]*:/)) return "labelName";
        const directive = stream.match(/^\.[A-Za-z]+/);
        const word = directive ?? stream.match(/^[A-Za-z_$][\w$.]*(,[Hh]\b)?/);
        if (word) {
          state.operands = true;
          if (!directive) return operation(word[0]);
          return directives.has(word[0].toLowerCase()) ? "processingInstruction" : "invalid";
        }
      }
      if (stream.match(/^X'[0-9A-Fa-f ]*'?/)) return "number";
      if (stream.match(/^(0x[0-9A-Fa-f]+|\d+(\.\d*)?([eE][-+]?\d+)?)/)) return "number";
      if (stream.match(/^\\[\w.+@]*/)) return "variableName.special";
      const word = stream.match(NAME);
      if (word) return /^[rh]\d+$/.test(word[0]) ? "atom" : "variableName";
      return stream.match(/^[[\](){}]/) ? "bracket" : (stream.next(), "operator");
    },
    languageData: { commentTokens: { line: ";" } },
    tokenTable: { docComment: tags.docComment },
  });
}

const colours = HighlightStyle.define([
  [tags.lineComment, "comment"], [tags.docComment, "expect"], [tags.string, "string"],
  [tags.labelName, "label"], [tags.keyword, "mnemonic"], [tags.macroName, "macro"],
  [tags.processingInstruction, "directive"], [tags.number, "number"], [tags.atom, "register"],
  [tags.special(tags.variableName), "register"], [tags.invalid, "unknown"],
].map(([tag, name]) => ({ tag, class: `word-${name}` })));

// --- Gutter: breakpoints and the current line ----------------------------------

const setBreaks = StateEffect.define();
const setCurrentLine = StateEffect.define();

class Mark extends GutterMarker {
  constructor(kind, title) { super(); this.kind = kind; this.title = title; }
  eq(other) { return other.kind === this.kind; }
  toDOM() { return el("span", { class: `mark-${this.kind}`, title: this.title }); }
}
const BREAK = new Mark("break", "a breakpoint");
const CURRENT_LINE = new Mark("current-line", "the next instruction");
const ROOM = new Mark("room", "");

const sum = (rows, key) => rows.reduce((all, row) => all + row[key], 0);

// The clocks of a line, which has a row for each form and region. A larger share of the run has a
// darker background.
class Clocks extends GutterMarker {
  constructor(rows) {
    super();
    this.clocks = sum(rows, "clocks");
    this.share = sum(rows, "percent") / 100;
    this.title = rows.map(({ form, clocks, percent, executions }) => `${form ? `${form}: ` : ""}` +
      `${some(clocks, "clock")}, ${fixed(percent, 1)} %, in ${some(executions, "execution")}`).join("\n");
  }
  eq(other) { return other.title === this.title; }
  toDOM() {
    const { share, title } = this;
    return el("span", { class: "clocks", style: `--share: ${share}`, title }, count(this.clocks));
  }
}

const lineStart = (doc, line) => doc.line(Math.min(Math.max(line, 1), doc.lines)).from;

const breaks = StateField.define({
  create: () => RangeSet.empty,
  update(marks, change) {
    marks = marks.map(change.changes);
    for (const effect of change.effects)
      if (effect.is(setBreaks))
        marks = RangeSet.of([...new Set(effect.value)]
          .map((line) => BREAK.range(lineStart(change.state.doc, line))), true);
    return marks;
  },
});

const setClocks = StateEffect.define();

const clocks = StateField.define({
  create: () => RangeSet.empty,
  update(marks, change) {
    for (const effect of change.effects)
      if (effect.is(setClocks))
        return RangeSet.of([...new Set(effect.value.map(({ line }) => line))].map((line) =>
          new Clocks(effect.value.filter((row) => row.line === line))
            .range(lineStart(change.state.doc, line))), true);
    return change.docChanged ? RangeSet.empty : marks;
  },
});

const currentLine = StateField.define({
  create: () => 0,
  update(line, change) {
    for (const effect of change.effects) if (effect.is(setCurrentLine)) return effect.value;
    return change.docChanged ? 0 : line;
  },
  provide: (field) => [
    EditorView.decorations.from(field, (line) => (view) => line
      ? Decoration.set(Decoration.line({ class: "current-line" }).range(lineStart(view.state.doc, line)))
      : Decoration.none),
  ],
});

function currentLineMarks(view) {
  const line = view.state.field(currentLine);
  return line ? RangeSet.of(CURRENT_LINE.range(lineStart(view.state.doc, line))) : RangeSet.empty;
}

// --- Editor ---------------------------------------------------------------------

// Inserts spaces up to the next multiple of eight columns. A selection is indented line by line.
function tab(view) {
  if (!view.state.selection.main.empty) return indentMore(view);
  const at = view.state.selection.main.head;
  const column = at - view.state.doc.lineAt(at).from;
  view.dispatch(view.state.replaceSelection(" ".repeat(TAB - column % TAB)),
    { userEvent: "input", scrollIntoView: true });
  return true;
}

// Returns the operands and the effect of an instruction from the instruction table.
function explain(about, word) {
  const row = about.instructions.find(({ mnemonic }) =>
    mnemonic.toUpperCase() === word.replace(/,h$/i, "").toUpperCase());
  return row && { mnemonic: row.mnemonic, name: `${row.mnemonic} ${row.operands}`.trim(), effect: row.effect };
}

/**
 * Creates the editor in PARENT. The callback CHANGED receives the text after each change. BREAKS
 * receives the lines that have breakpoints. AT receives the table's entry for the word at the
 * cursor. HELP receives the mnemonic at the cursor, if any, when F1 is pressed. TOOLONG receives the
 * length of a rejected text.
 */
export function makeEditor(parent, about, { changed, breaks: broken, at, help, tooLong }) {
  // Rejects each change that makes a text longer than the limit, by paste, drop or typing. A text
  // that is already too long may become shorter.
  const limit = EditorState.transactionFilter.of((change) => {
    const length = change.changes.newLength;
    if (length <= Math.max(MAX_PROGRAM, change.startState.doc.length)) return change;
    tooLong(length);
    return [];
  });
  const lines = (state) => {
    const found = [];
    state.field(breaks).between(0, state.doc.length, (from) => {
      found.push(state.doc.lineAt(from).number);
    });
    return found;
  };
  const toggle = (view, position) => {
    const line = view.state.doc.lineAt(position).number;
    const now = lines(view.state);
    const next = now.includes(line) ? now.filter((one) => one !== line) : [...now, line];
    view.dispatch({ effects: setBreaks.of(next) });
    broken(next);
    return true;
  };
  const wordAt = (state, position) => {
    const { from, text } = state.doc.lineAt(position);
    const statement = /^\s*(?:[A-Za-z_$][\w$.]*:\s*)*([A-Za-z_$][\w$.]*)/.exec(text);
    return statement && { from: from + statement[0].length - statement[1].length,
      to: from + statement[0].length, word: statement[1] };
  };
  const tooltip = hoverTooltip((view, position) => {
    const found = wordAt(view.state, position);
    if (!found || position < found.from || position > found.to) return null;
    const explanation = explain(about, found.word);
    return explanation && { pos: found.from, end: found.to, create: () => ({
      dom: el("div", { class: "effect" }, el("code", {}, explanation.name), " ", explanation.effect) }) };
  });

  const extensions = [
    limit, breaks, currentLine, clocks,
    gutter({
      class: "cm-breaks",
      markers: (editor) => [editor.state.field(breaks), currentLineMarks(editor)],
      lineMarkerChange: (update) => update.startState.field(currentLine) !== update.state.field(currentLine),
      initialSpacer: () => ROOM,
      domEventHandlers: { mousedown: (editor, block) => toggle(editor, block.from) },
    }),
    lineNumbers({ domEventHandlers: { mousedown: (editor, block) => toggle(editor, block.from) } }),
    gutter({ class: "cm-clocks", markers: (editor) => editor.state.field(clocks) }),
    history(), drawSelection(), highlightActiveLine(), bracketMatching(), tooltip,
    EditorState.tabSize.of(TAB),
    language(about), syntaxHighlighting(colours),
    keymap.of([
      { key: "F1", run: (editor) => {
        const found = wordAt(editor.state, editor.state.selection.main.head);
        help(found && explain(about, found.word)?.mnemonic);
        return true;
      } },
      { key: "F9", run: (editor) => toggle(editor, editor.state.selection.main.head) },
      { key: "Tab", run: tab },
      ...defaultKeymap, ...historyKeymap]),
    EditorView.contentAttributes.of({ tabindex: "0", "aria-label": "Text of the program",
      "aria-description": "F9 sets a breakpoint at the line; Escape, then Tab leaves the text" }),
    EditorView.updateListener.of((update) => {
      if (update.docChanged) changed(update.state.doc.toString());
      if (update.docChanged || update.selectionSet) {
        const found = wordAt(update.state, update.state.selection.main.head);
        at(found && explain(about, found.word));
      }
    }),
  ];
  const view = new EditorView({ parent });

  // Scrolls the editor, but not the page, until a line and AROUND lines on each side are visible.
  function bringIntoSight(position, around) {
    const { height, ...line } = view.lineBlockAt(position);
    const top = line.top + view.documentPadding.top, bottom = top + height;
    const { scrollTop, clientHeight } = view.scrollDOM;
    const margin = Math.min(around * height, (clientHeight - height) / 2);
    if (top - margin < scrollTop) view.scrollDOM.scrollTop = top - margin;
    else if (bottom + margin > scrollTop + clientHeight)
      view.scrollDOM.scrollTop = bottom + margin - clientHeight;
  }

  // Keeps the line with the cursor visible if the list of errors below the editor makes it smaller.
  new ResizeObserver(() => {
    if (view.hasFocus) bringIntoSight(view.state.selection.main.head, MARGIN / 8);
  }).observe(view.scrollDOM);

  return {
    view,
    get text() { return view.state.doc.toString(); },
    /** Replaces the text and clears the undo history. */
    set(text) {
      view.setState(EditorState.create({ doc: text, extensions }));
      at(null);
    },
    /** Replaces the text like typing, so the change can be undone. */
    type(text) {
      view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: text }, userEvent: "input" });
    },
    setBreaks(list) {
      view.dispatch({ effects: setBreaks.of(list) });
    },
    /** Scrolls to the place for the learner's code, or to the start of the text. */
    toExercise() {
      const at = view.state.doc.toString().search(/your code here/i);
      view.scrollDOM.scrollTop = at < 0 ? 0 : view.lineBlockAt(at).top - view.scrollDOM.clientHeight / 4;
    },
    /** Marks the current line, and scrolls to it if VISIBLE. 0 removes the mark. */
    markLine(line, visible = true) {
      view.dispatch({ effects: setCurrentLine.of(line) });
      if (line && visible) bringIntoSight(lineStart(view.state.doc, line), MARGIN);
    },
    /** Shows clocks next to lines. A row is {line, form, clocks, percent, executions}. */
    charge(rows) {
      view.dispatch({ effects: setClocks.of(rows) });
    },
    toLine(line, column = 1) {
      const { from, to } = view.state.doc.line(Math.min(Math.max(line, 1), view.state.doc.lines));
      const anchor = Math.min(from + Math.max(column, 1) - 1, to);
      view.dispatch({ selection: { anchor }, scrollIntoView: true });
      view.focus();
    },
    /** Marks errors and warnings, which are {severity, line, column, length, message}. */
    showDiagnostics(diagnostics) {
      const { doc } = view.state;
      view.dispatch(setDiagnostics(view.state, diagnostics.filter((one) => one.line).map((one) => {
        const { from, to } = doc.line(Math.min(one.line, doc.lines));
        const begin = Math.min(from + Math.max((one.column ?? 1) - 1, 0), to);
        return { from: begin, to: one.length ? Math.min(begin + one.length, to) : to,
          severity: one.severity === "warning" ? "warning" : "error", message: one.message };
      })));
    },
  };
}
