import type { Plugin } from 'vite';

/** Adds each script and style sheet compressed with Brotli. */
export function brotli(): Plugin;
