import { useComputedColorScheme } from '@mantine/core';
import { useEffect, useRef } from 'react';
import classes from './code.module.css';

interface DifferenceProps {
  label: string;
  path: string;
  before: string;
  now: string;
}

/** Two versions of a file side by side. */
export function Difference({ label, path, before, now }: DifferenceProps) {
  const place = useRef<HTMLDivElement>(null);
  const dark = useComputedColorScheme('light') === 'dark';
  useEffect(() => {
    let view: { destroy: () => void } | undefined;
    let disposed = false;
    void import('./editor').then(({ createDifference }) => {
      if (disposed || !place.current) return;
      view = createDifference({ parent: place.current, path, before, now, dark, label });
    });
    return () => {
      disposed = true;
      view?.destroy();
    };
  }, [path, before, now, dark, label]);
  return <div ref={place} className={classes.difference} />;
}
