import { useComputedColorScheme } from '@mantine/core';
import { useEffect, useRef } from 'react';
import classes from './code.module.css';
import type { Editor } from './editor';

interface CodeEditorProps {
  label: string;
  /** Its ending says which language it is. */
  path: string;
  text: string;
  onChange?: (text: string) => void;
  /** The line to show, from 1. */
  line?: number | undefined;
  height?: string;
}

/** Text of a file with its language's colours; its library is loaded with the first one shown. */
export function CodeEditor({
  label,
  path,
  text,
  onChange,
  line,
  height = '60vh',
}: CodeEditorProps) {
  const place = useRef<HTMLDivElement>(null);
  const editor = useRef<Editor>(undefined);
  const latest = useRef({ text, onChange, line });
  const dark = useComputedColorScheme('light') === 'dark';
  const readOnly = !onChange;
  useEffect(() => {
    latest.current = { text, onChange, line };
    editor.current?.setText(text);
  }, [text, onChange, line]);
  useEffect(() => {
    if (line) editor.current?.reveal(line);
  }, [line]);
  useEffect(() => {
    let gone = false;
    void import('./editor').then(({ createEditor }) => {
      if (gone || !place.current) return;
      editor.current = createEditor({
        parent: place.current,
        path,
        text: latest.current.text,
        dark,
        readOnly,
        label,
        onChange: (next) => latest.current.onChange?.(next),
      });
      if (latest.current.line) editor.current.reveal(latest.current.line);
    });
    return () => {
      gone = true;
      editor.current?.destroy();
      editor.current = undefined;
    };
  }, [path, dark, readOnly, label]);
  return <div ref={place} className={classes.editor} style={{ height }} />;
}
