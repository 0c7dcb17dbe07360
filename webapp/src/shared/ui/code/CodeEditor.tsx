import { useComputedColorScheme } from '@mantine/core';
import { useEffect, useRef } from 'react';
import classes from './code.module.css';
import type { Editor, LineMark } from './editor';

interface CodeEditorProps {
  label: string;
  /** The file extension selects the language. */
  path: string;
  text: string;
  onChange?: (text: string) => void;
  /** The line to scroll to, from 1. */
  line?: number | undefined;
  height?: string;
  /** Marks of lines; for read-only text. */
  marks?: readonly LineMark[];
}

/** An editor with syntax highlighting. CodeMirror is loaded when the first one is shown. */
export function CodeEditor({
  label,
  path,
  text,
  onChange,
  line,
  height = '60vh',
  marks,
}: CodeEditorProps) {
  const place = useRef<HTMLDivElement>(null);
  const editor = useRef<Editor>(undefined);
  const latest = useRef({ text, onChange, line, marks });
  const dark = useComputedColorScheme('light') === 'dark';
  const readOnly = !onChange;
  useEffect(() => {
    latest.current = { text, onChange, line, marks };
    editor.current?.setText(text);
  }, [text, onChange, line, marks]);
  useEffect(() => {
    if (line) editor.current?.reveal(line);
  }, [line]);
  useEffect(() => {
    let disposed = false;
    void import('./editor').then(({ createEditor }) => {
      if (disposed || !place.current) return;
      editor.current = createEditor({
        parent: place.current,
        path,
        text: latest.current.text,
        dark,
        readOnly,
        label,
        marks: latest.current.marks ?? [],
        onChange: (next) => latest.current.onChange?.(next),
      });
      if (latest.current.line) editor.current.reveal(latest.current.line);
    });
    return () => {
      disposed = true;
      editor.current?.destroy();
      editor.current = undefined;
    };
  }, [path, dark, readOnly, label]);
  return <div ref={place} className={classes.editor} style={{ height }} />;
}
