import { Input, useComputedColorScheme } from '@mantine/core';
import { useEffect, useRef } from 'react';
import classes from './code.module.css';
import type { Editor } from './editor';

/** Names that a field completes. */
export type Words = readonly { label: string; detail: string }[];

interface FormulaProps {
  label: string;
  /** Whether the label is visible; in a table the heading of the column says the same. */
  labelled?: boolean;
  description?: string | undefined;
  error?: string | undefined;
  text: string;
  words: Words;
  onChange: (text: string) => void;
}

/** A field for a CEL expression, with completion of names. */
export function Formula({
  label,
  labelled = true,
  description,
  error,
  text,
  words,
  onChange,
}: FormulaProps) {
  const place = useRef<HTMLDivElement>(null);
  const editor = useRef<Editor>(undefined);
  const latest = useRef({ text, onChange });
  const dark = useComputedColorScheme('light') === 'dark';
  const key = JSON.stringify(words);
  useEffect(() => {
    latest.current = { text, onChange };
    editor.current?.setText(text);
  }, [text, onChange]);
  useEffect(() => {
    let disposed = false;
    void import('./editor').then(({ createFormula }) => {
      if (disposed || !place.current) return;
      editor.current = createFormula({
        parent: place.current,
        text: latest.current.text,
        dark,
        label,
        words: JSON.parse(key) as { label: string; detail: string }[],
        onChange: (next) => {
          latest.current.onChange(next);
        },
      });
    });
    return () => {
      disposed = true;
      editor.current?.destroy();
      editor.current = undefined;
    };
  }, [dark, label, key]);
  return (
    <Input.Wrapper
      label={labelled && label}
      description={description}
      error={error}
      labelElement="div"
    >
      <div ref={place} className={classes.formula} />
    </Input.Wrapper>
  );
}
