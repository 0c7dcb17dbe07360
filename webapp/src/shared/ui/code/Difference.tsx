import { useComputedColorScheme } from '@mantine/core';
import { useEffect, useRef } from 'react';
import classes from './code.module.css';

interface DifferenceProps {
  label: string;
  path: string;
  before: string;
  now: string;
}

/** Two versions of a file beside each other. */
export function Difference({ label, path, before, now }: DifferenceProps) {
  const place = useRef<HTMLDivElement>(null);
  const dark = useComputedColorScheme('light') === 'dark';
  useEffect(() => {
    let view: { destroy: () => void } | undefined;
    let gone = false;
    void import('./editor').then(({ createDifference }) => {
      if (gone || !place.current) return;
      view = createDifference({ parent: place.current, path, before, now, dark, label });
    });
    return () => {
      gone = true;
      view?.destroy();
    };
  }, [path, before, now, dark, label]);
  return <div ref={place} className={classes.difference} />;
}
