import { EditorView } from '@codemirror/view';
import { describe, expect, test } from 'vitest';
import { createEditor, createFormula } from '@/shared/ui/code/editor';

const SETTINGS = {
  path: 'a.py',
  dark: false,
  readOnly: false,
  label: 'Text',
  marks: [],
  words: [],
};

describe.each([
  ['a file', createEditor],
  ['a formula', createFormula],
])('the editor of %s', (_, create) => {
  function open(text: string) {
    const parent = document.body.appendChild(document.createElement('div'));
    const reported: string[] = [];
    const editor = create({ ...SETTINGS, parent, text, onChange: (next) => reported.push(next) });
    const view = EditorView.findFromDOM(parent);
    if (!view) throw new Error('no editor');
    const type = (typed: string) => {
      const { from } = view.state.selection.main;
      view.dispatch({
        changes: { from, insert: typed },
        selection: { anchor: from + typed.length },
        userEvent: 'input.type',
      });
    };
    return { editor, view, type, reported };
  }

  test('keeps keys that were typed before the page gave back the text without them', () => {
    const { editor, view, type, reported } = open('');
    type('a');
    type('b');
    editor.setText('a');
    type('c');
    editor.setText('ab');
    editor.setText('abc');
    expect(view.state.doc.toString()).toBe('abc');
    expect(view.state.selection.main.from).toBe(3);
    expect(reported).toEqual(['a', 'ab', 'abc']);
  });

  test('keeps keys when the page is shown again with the text from before', () => {
    const { editor, view, type } = open('x');
    type('a');
    editor.setText('x');
    expect(view.state.doc.toString()).toBe('ax');
  });

  test('takes a text that the page sets, also one from before', () => {
    const { editor, view, type } = open('');
    type('a');
    editor.setText('a');
    type('b');
    editor.setText('ab');
    editor.setText('other');
    expect(view.state.doc.toString()).toBe('other');
    editor.setText('a');
    expect(view.state.doc.toString()).toBe('a');
  });
});
