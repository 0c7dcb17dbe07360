import { autocompletion, type CompletionSource } from '@codemirror/autocomplete';
import { defaultKeymap, history, historyKeymap } from '@codemirror/commands';
import { cpp } from '@codemirror/lang-cpp';
import { java } from '@codemirror/lang-java';
import { python } from '@codemirror/lang-python';
import { xml } from '@codemirror/lang-xml';
import { yaml } from '@codemirror/lang-yaml';
import {
  bracketMatching,
  defaultHighlightStyle,
  foldGutter,
  HighlightStyle,
  syntaxHighlighting,
} from '@codemirror/language';
import { MergeView } from '@codemirror/merge';
import { Compartment, EditorState, RangeSet, type Extension } from '@codemirror/state';
import {
  Decoration,
  drawSelection,
  EditorView,
  gutter,
  GutterMarker,
  highlightActiveLine,
  highlightSpecialChars,
  keymap,
  lineNumbers,
} from '@codemirror/view';
import { tags } from '@lezer/highlight';

const LANGUAGES: readonly [RegExp, () => Extension][] = [
  [/\.java$/, java],
  [/\.(c|cc|cpp|cxx|h|hpp|hxx|idl|proto)$/, cpp],
  [/\.py$/, python],
  [/\.(xml|xsd|urdf|sdf)$/, xml],
  [/\.ya?ml$/, yaml],
];

const DARK = HighlightStyle.define([
  { tag: tags.keyword, color: '#c792ea' },
  { tag: [tags.string, tags.attributeValue], color: '#a5d68f' },
  { tag: [tags.number, tags.bool, tags.null], color: '#f5a97f' },
  { tag: [tags.comment, tags.meta], color: '#9aa5b1', fontStyle: 'italic' },
  { tag: [tags.typeName, tags.className, tags.tagName], color: '#7fc8ff' },
  { tag: [tags.propertyName, tags.attributeName], color: '#e6c97a' },
]);

/** A mark of a line: a sign in the gutter, a colour and a tooltip. */
export interface LineMark {
  /** From 1. */
  line: number;
  kind: 'reached' | 'partly' | 'missed';
  sign: string;
  title: string;
}

class Sign extends GutterMarker {
  constructor(private readonly mark: LineMark) {
    super();
    this.elementClass = `cm-sign-${mark.kind}`;
  }

  override toDOM() {
    const sign = document.createElement('span');
    sign.textContent = this.mark.sign;
    sign.title = this.mark.title;
    return sign;
  }
}

/** A bar instead of a background, to keep the contrast of the syntax colours. */
const MARK_COLOURS = EditorView.baseTheme({
  '&light .cm-line-missed': { boxShadow: 'inset 4px 0 0 #a32018' },
  '&dark .cm-line-missed': { boxShadow: 'inset 4px 0 0 #ff9a91' },
  '&light .cm-line-partly': { boxShadow: 'inset 4px 0 0 #b98a1f' },
  '&dark .cm-line-partly': { boxShadow: 'inset 4px 0 0 #f0bf5c' },
  '.cm-signs': { minWidth: '2.2rem', textAlign: 'center' },
  '&light .cm-sign-reached': { color: '#1b6e36' },
  '&dark .cm-sign-reached': { color: '#6fd08c' },
  '&light .cm-sign-partly': { color: '#704b00' },
  '&dark .cm-sign-partly': { color: '#f0bf5c' },
  '&light .cm-sign-missed': { color: '#a32018' },
  '&dark .cm-sign-missed': { color: '#ff9a91' },
});

function marked(marks: readonly LineMark[]): Extension {
  if (marks.length === 0) return [];
  return [
    MARK_COLOURS,
    EditorView.decorations.compute(['doc'], ({ doc }) =>
      Decoration.set(
        marks
          .filter(({ line, kind }) => kind !== 'reached' && line <= doc.lines)
          .map(({ line, kind }) =>
            Decoration.line({ class: `cm-line-${kind}` }).range(doc.line(line).from),
          ),
      ),
    ),
    gutter({
      class: 'cm-signs',
      markers: ({ state: { doc } }) =>
        RangeSet.of(
          marks
            .filter(({ line }) => line <= doc.lines)
            .map((mark) => new Sign(mark).range(doc.line(mark.line).from)),
        ),
    }),
  ];
}

export interface EditorSettings {
  parent: HTMLElement;
  /** The file extension selects the language. */
  path: string;
  text: string;
  dark: boolean;
  readOnly: boolean;
  label: string;
  /** By line. */
  marks: readonly LineMark[];
  onChange: (text: string) => void;
}

export interface Editor {
  destroy: () => void;
  setText: (text: string) => void;
  reveal: (line: number) => void;
}

/**
 * Tells texts that a page sets from those that were typed. A page gives back what it got from an
 * editor, on a busy machine after the next keys: to set that would undo them and move the cursor.
 */
class GivenText {
  /** Reported to the page, which has not given them back. */
  private reported: string[] = [];

  constructor(private last: string) {}

  /** Notes a text that is reported to the page. */
  typed(text: string): string {
    this.reported.push(text);
    return text;
  }

  /** Whether the page sets another text than the last one and those that it got. */
  isNew(text: string): boolean {
    if (text === this.last) return false;
    this.last = text;
    const position = this.reported.indexOf(text);
    this.reported = position < 0 ? [] : this.reported.slice(position + 1);
    return position < 0;
  }
}

function basics(path: string, dark: boolean, label: string): Extension[] {
  return [
    lineNumbers(),
    foldGutter(),
    // Shows control characters and direction marks.
    highlightSpecialChars(),
    drawSelection(),
    bracketMatching(),
    syntaxHighlighting(dark ? DARK : defaultHighlightStyle),
    EditorView.theme({}, { dark }),
    EditorView.contentAttributes.of({ 'aria-label': label }),
    LANGUAGES.find(([ending]) => ending.test(path))?.[1]() ?? [],
  ];
}

export function createEditor(settings: EditorSettings): Editor {
  const { parent, path, text, dark, readOnly, label, marks, onChange } = settings;
  const given = new GivenText(text);
  const editable = new Compartment();
  const view = new EditorView({
    parent,
    state: EditorState.create({
      doc: text,
      extensions: [
        marked(marks),
        basics(path, dark, label),
        history(),
        readOnly ? [] : highlightActiveLine(),
        keymap.of([...defaultKeymap, ...historyKeymap]),
        // Tab leaves the editor, for keyboard users.
        editable.of([EditorState.readOnly.of(readOnly)]),
        EditorView.updateListener.of((update) => {
          if (update.docChanged) onChange(given.typed(update.state.doc.toString()));
        }),
      ],
    }),
  });
  // Focusable, so that it can be scrolled by keyboard.
  if (readOnly) view.scrollDOM.tabIndex = 0;
  return {
    destroy: () => {
      view.destroy();
    },
    setText: (next) => {
      if (!given.isNew(next) || next === view.state.doc.toString()) return;
      view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: next } });
    },
    reveal: (line) => {
      const at = view.state.doc.line(Math.min(Math.max(1, line), view.state.doc.lines)).from;
      view.dispatch({ selection: { anchor: at }, effects: EditorView.scrollIntoView(at) });
      view.focus();
    },
  };
}

export interface DifferenceSettings {
  parent: HTMLElement;
  path: string;
  before: string;
  now: string;
  dark: boolean;
  label: string;
}

/** Two texts side by side with their differences. */
export function createDifference(settings: DifferenceSettings): { destroy: () => void } {
  const { parent, path, before, now, dark, label } = settings;
  const side = (text: string, name: string) => ({
    doc: text,
    extensions: [basics(path, dark, `${label}: ${name}`), EditorState.readOnly.of(true)],
  });
  const view = new MergeView({
    parent,
    a: side(before, 'generated'),
    b: side(now, 'modified'),
    collapseUnchanged: { margin: 3, minSize: 6 },
  });
  return {
    destroy: () => {
      view.destroy();
    },
  };
}

export interface FormulaSettings {
  parent: HTMLElement;
  text: string;
  dark: boolean;
  label: string;
  /** Names for completion, with a description. */
  words: readonly { label: string; detail: string }[];
  onChange: (text: string) => void;
}

/** A CEL editor with completion of names. */
export function createFormula(settings: FormulaSettings): Editor {
  const { parent, text, dark, label, words, onChange } = settings;
  const given = new GivenText(text);
  const complete: CompletionSource = (context) => {
    const word = context.matchBefore(/[\w.[\]]*/);
    if (!word || (word.from === word.to && !context.explicit)) return null;
    return {
      from: word.from,
      options: words.map(({ label: name, detail }) => ({ label: name, detail, type: 'variable' })),
    };
  };
  const view = new EditorView({
    parent,
    state: EditorState.create({
      doc: text,
      extensions: [
        history(),
        highlightSpecialChars(),
        bracketMatching(),
        cpp(),
        syntaxHighlighting(dark ? DARK : defaultHighlightStyle),
        EditorView.theme({}, { dark }),
        EditorView.contentAttributes.of({ 'aria-label': label }),
        EditorView.lineWrapping,
        autocompletion({ override: [complete] }),
        keymap.of([...defaultKeymap, ...historyKeymap]),
        EditorView.updateListener.of((update) => {
          if (update.docChanged) onChange(given.typed(update.state.doc.toString()));
        }),
      ],
    }),
  });
  return {
    destroy: () => {
      view.destroy();
    },
    setText: (next) => {
      if (!given.isNew(next) || next === view.state.doc.toString()) return;
      view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: next } });
    },
    reveal: () => {
      view.focus();
    },
  };
}
