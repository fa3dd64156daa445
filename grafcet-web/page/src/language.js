// What the editor knows of the notation: colours, comments, brackets, words to complete.

import { HighlightStyle, LanguageSupport, StreamLanguage, indentUnit, syntaxHighlighting } from "@codemirror/language";
import { highlightCode, tagHighlighter, tags } from "@lezer/highlight";

// The first words of items, and what stands within them (docs/language.md).
export const ITEMS = ["input", "output", "var", "param", "let", "action", "clock", "max_evolutions", "budget", "assume", "optimize",
  "encoding", "forceable", "modes", "never", "always", "home", "initial", "final", "linked", "entry", "exit", "macro", "enclosing",
  "step", "partial", "sfc", "grafcet", "plant"];
const WITHIN = ["if", "else", "any", "in", "pub", "crate", "within", "often", "force", "rising", "falling"];
const QUALIFIERS = ["N", "S", "R", "P", "P0", "P1", "L", "D", "SD", "DS", "SL"];
const TYPES = /^(bool|u8|u16|u32|u64|u128|i8|i16|i32|i64|i128|usize|isize|f32|f64|time)$/;

const items = new Set(ITEMS), within = new Set(WITHIN), qualifiers = new Set(QUALIFIERS);

function comment(stream, state) {
  while (!stream.eol()) {
    if (stream.match("/*")) state.depth++;
    else if (stream.match("*/")) { if (--state.depth === 0) return "comment"; }
    else stream.next();
  }
  return "comment";
}

function word(stream, text) {
  if (text === "true" || text === "false") return "bool";
  if (items.has(text)) return "keyword";
  if (within.has(text)) return "modifier";
  if (TYPES.test(text)) return "typeName";
  if (qualifiers.has(text) && stream.match(/^(?=[ \t(])/, false)) return "operatorKeyword";
  if (stream.match(/^(?=\s*\()/, false)) return "function";
  // Steps, macro-steps and partial grafcets are written with a capital, signals without.
  if (/^[A-Z][A-Z0-9_]+$/.test(text)) return "constant";
  return /^[A-Z]/.test(text) ? "className" : "variableName";
}

const chart = StreamLanguage.define({
  name: "grafcet",
  startState: () => ({ depth: 0 }),
  copyState: state => ({ ...state }),
  token(stream, state) {
    if (state.depth > 0) return comment(stream, state);
    if (stream.eatSpace()) return null;
    if (stream.match(/^\/\/[/!][^\n]*/)) return "docComment";
    if (stream.match(/^\/\/[^\n]*/)) return "comment";
    if (stream.match("/*")) { state.depth = 1; return comment(stream, state); }
    if (stream.match(/^"(?:[^"\\]|\\.)*"?/)) return "string";
    if (stream.match(/^#!?\[[^\]]*\]/)) return "meta";
    if (stream.match(/^\d[\d_]*(\.\d+)?(ms|us|s|min|m|h|d)(\d[\d_]*(ms|s|m)?)*\b/)) return "unit";
    if (stream.match(/^(0x[\da-fA-F_]+|0b[01_]+|\d[\d_]*(\.\d+)?([uif]\d+)?)/)) return "number";
    if (stream.match(/^(->|-\[|\]->|\]-)/)) return "arrow";
    const found = stream.match(/^(r#)?[\p{L}_][\p{L}\p{N}_]*/u);
    if (found) return word(stream, found[0]);
    if (stream.match(/^[{}()[\]]/)) return "bracket";
    stream.next();
    return "operator";
  },
  indent(state, after, context) {
    const before = context.lineAt(context.pos, -1);
    const above = before.from > 0 ? context.state.doc.lineAt(before.from - 1) : null;
    if (!above) return 0;
    const opens = (above.text.match(/[{(]/g) ?? []).length - (above.text.match(/[})]/g) ?? []).length;
    const indent = context.lineIndent(above.from) + (opens > 0 ? context.unit : 0);
    return Math.max(0, /^\s*[})]/.test(after) ? indent - context.unit : indent);
  },
  tokenTable: { arrow: tags.controlOperator, unit: tags.unit, constant: tags.constant(tags.variableName), function: tags.function(tags.variableName) },
  languageData: { commentTokens: { line: "//", block: { open: "/*", close: "*/" } }, closeBrackets: { brackets: ["(", "[", "{", '"'] }, indentOnInput: /^\s*[})]$/ },
});

// The colours are the page's own (style.css), so that light and dark need nothing here.
export const looks = [
  { name: "word", tag: tags.keyword, color: "var(--code-word)", fontWeight: "600" },
  { name: "modifier", tag: tags.modifier, color: "var(--code-word)" },
  { name: "qualifier", tag: tags.operatorKeyword, color: "var(--code-qualifier)", fontWeight: "600" },
  { name: "type", tag: [tags.typeName, tags.meta], color: "var(--code-type)" },
  { name: "step", tag: tags.className, color: "var(--code-step)", fontWeight: "600" },
  { name: "value", tag: [tags.number, tags.unit, tags.bool, tags.string, tags.constant(tags.variableName)], color: "var(--code-value)" },
  { name: "arrow", tag: tags.controlOperator, color: "var(--code-arrow)", fontWeight: "600" },
  { name: "call", tag: tags.function(tags.variableName), color: "var(--code-call)" },
  { name: "comment", tag: [tags.comment, tags.docComment], color: "var(--soft)", fontStyle: "italic" },
];
const colours = HighlightStyle.define(looks.map(({ name, ...look }) => look));
const named = tagHighlighter(looks.map(({ name, tag }) => ({ tag, class: name })));

// Hands over a text piece by piece, each with the name of its look.
export function highlighted(text, put) {
  highlightCode(text, chart.parser.parse(text), named, put, () => put("\n", ""));
}

const SNIPPETS = { N: "while the step is active", S: "set", R: "reset", P: "once", P1: "on entry", P0: "on exit", L: "limited", D: "delayed",
  SD: "stored and delayed", DS: "delayed and stored", SL: "stored and limited" };

// `words()` are the names of the chart as the compiler knows them: pairs of name and kind.
export function completions(words) {
  const fixed = [...ITEMS.map(label => ({ label, type: "keyword", boost: -1 })),
    ...QUALIFIERS.map(label => ({ label, type: "type", detail: SNIPPETS[label], boost: -1 }))];
  return context => {
    const typed = context.matchBefore(/[\p{L}_][\p{L}\p{N}_]*/u);
    if (!typed && !context.explicit) return null;
    const named = words().map(([label, kind]) => ({ label, detail: kind, type: /step|grafcet/.test(kind) ? "class" : "variable", boost: 1 }));
    return { from: typed ? typed.from : context.pos, options: [...named, ...fixed], validFor: /^[\p{L}\p{N}_]*$/u };
  };
}

export function language() {
  return [new LanguageSupport(chart), syntaxHighlighting(colours), indentUnit.of("    ")];
}
