// The editor of a chart: CodeMirror, in a shadow tree of its own. There its styles are sheets of the script and not elements, which the page's policy
// for contents would refuse.

import { autocompletion, closeBrackets, closeBracketsKeymap, completionKeymap } from "@codemirror/autocomplete";
import { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands";
import { bracketMatching, indentOnInput } from "@codemirror/language";
import { forEachDiagnostic, lintGutter, lintKeymap, setDiagnostics } from "@codemirror/lint";
import { highlightSelectionMatches, searchKeymap } from "@codemirror/search";
import { EditorState } from "@codemirror/state";
import { EditorView, drawSelection, highlightActiveLine, highlightActiveLineGutter, keymap, lineNumbers } from "@codemirror/view";

import { rich } from "../../../cargo-grafcet/src/watch/page/rich.js";
import { completions, language } from "./language.js";

const look = EditorView.theme({
  "&": { height: "100%", color: "var(--ink)", backgroundColor: "var(--paper)", fontSize: "13.5px" },
  "&.cm-focused": { outline: "none" },
  ".cm-scroller": { fontFamily: "var(--mono)", lineHeight: "1.55" },
  ".cm-content": { padding: "10px 0", caretColor: "var(--ink)" },
  ".cm-cursor": { borderLeftColor: "var(--ink)", borderLeftWidth: "1.5px" },
  ".cm-gutters": { backgroundColor: "transparent", color: "var(--soft)", border: "none" },
  ".cm-activeLine, .cm-activeLineGutter": { backgroundColor: "var(--line)" },
  ".cm-selectionBackground, &.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground": { backgroundColor: "var(--select)" },
  ".cm-matchingBracket, &.cm-focused .cm-matchingBracket": { backgroundColor: "var(--select)", outline: "none" },
  ".cm-selectionMatch": { backgroundColor: "var(--line)" },
  ".cm-tooltip": { backgroundColor: "var(--raised)", color: "var(--ink)", border: "1px solid var(--edge)", borderRadius: "8px", boxShadow: "var(--shadow)", overflow: "hidden", maxWidth: "min(60ch, 92vw)" },
  ".cm-tooltip-autocomplete > ul": { fontFamily: "var(--mono)", fontSize: "13px" },
  ".cm-tooltip-autocomplete > ul > li[aria-selected]": { backgroundColor: "var(--accent)", color: "var(--on-accent)" },
  ".cm-completionDetail": { fontStyle: "normal", color: "var(--soft)" },
  "li[aria-selected] .cm-completionDetail": { color: "inherit" },
  ".cm-diagnostic": { padding: "8px 12px", borderLeft: "3px solid var(--bad)", fontFamily: "var(--sans)", fontSize: "13px", lineHeight: "1.45", whiteSpace: "normal" },
  ".cm-diagnostic-warning": { borderLeftColor: "var(--warn)" },
  ".cm-diagnostic a": { color: "var(--accent)" },
  ".cm-lintRange-error, .cm-lintRange-warning": { backgroundImage: "none", textDecoration: "underline wavy var(--bad) 1px", textUnderlineOffset: "3px" },
  ".cm-lintRange-warning": { textDecorationColor: "var(--warn)" },
  // The marks of the library are pictures within its styles, which the page's policy refuses.
  ".cm-gutter-lint": { width: "14px" },
  ".cm-lint-marker": { width: "9px", height: "9px", margin: "0.45em 2px", borderRadius: "50%" },
  ".cm-lint-marker-error": { content: "''", backgroundColor: "var(--bad)" },
  ".cm-lint-marker-warning": { content: "''", backgroundColor: "var(--warn)" },
  ".cm-panels": { backgroundColor: "var(--raised)", color: "var(--ink)", borderColor: "var(--edge)" },
  ".cm-textfield, .cm-button": { backgroundImage: "none", backgroundColor: "var(--paper)", color: "var(--ink)", border: "1px solid var(--edge)", borderRadius: "5px" },
});

export function ruleLink(rule) {
  const link = document.createElement("a");
  link.href = `rules.html#${rule}`;
  link.target = "_blank";
  link.textContent = `grafcet::${rule}`;
  return link;
}

export class Editor {
  #view;

  // `changed` is called with each new text; `words` are the names to complete.
  constructor(place, { text, changed, words }) {
    const root = place.attachShadow({ mode: "open" });
    const extensions = [
      lineNumbers(), lintGutter(), highlightActiveLineGutter(), highlightActiveLine(), history(), drawSelection(), indentOnInput(), bracketMatching(),
      closeBrackets(), highlightSelectionMatches(), EditorState.tabSize.of(4), look, language(),
      autocompletion({ override: [completions(words)] }),
      // Escape, then Tab, leads out of the editor.
      keymap.of([...closeBracketsKeymap, ...defaultKeymap, ...searchKeymap, ...historyKeymap, ...completionKeymap, ...lintKeymap, indentWithTab]),
      EditorView.contentAttributes.of({ "aria-label": "The chart as text", spellcheck: "false", tabindex: "0" }),
      EditorView.updateListener.of(update => { if (update.docChanged) changed(update.state.doc.toString()); }),
    ];
    this.#view = new EditorView({ state: EditorState.create({ doc: text, extensions }), parent: root, root });
  }

  get text() { return this.#view.state.doc.toString(); }

  replace(text) {
    this.#view.dispatch({ changes: { from: 0, to: this.#view.state.doc.length, insert: text }, selection: { anchor: 0 }, scrollIntoView: true });
  }

  // Leads to a place of the text.
  go(from, to) {
    const end = this.#view.state.doc.length;
    this.#view.dispatch({ selection: { anchor: Math.min(from, end), head: Math.min(to, end) }, effects: EditorView.scrollIntoView(Math.min(from, end), { y: "center" }) });
    this.#view.focus();
  }

  // Each note of a message at its own place.
  mark(messages) {
    const end = this.#view.state.doc.length;
    const marks = messages.flatMap(({ level, rule, notes }) => notes.map(note => ({
      from: Math.min(note.from, end), to: Math.min(note.to, end), severity: level, message: note.text,
      renderMessage: () => {
        const box = document.createElement("div");
        box.append(...rich(note.text.replace(/ \[grafcet::\w+\]$/, "")));
        if (rule) box.append(" ", ruleLink(rule));
        return box;
      },
    })));
    this.#view.dispatch(setDiagnostics(this.#view.state, marks));
  }

  // What is marked, for tests.
  get marks() {
    const all = [];
    forEachDiagnostic(this.#view.state, (one, from, to) => all.push({ from, to, severity: one.severity, message: one.message, text: this.#view.state.sliceDoc(from, to) }));
    return all;
  }
}
