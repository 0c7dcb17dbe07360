import type { Plugin } from 'vite';

/** Lets the browser paint the header of index.html before it has the style sheets. */
export function shellFirst(): Plugin;
