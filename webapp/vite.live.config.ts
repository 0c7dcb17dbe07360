import { fileURLToPath } from 'node:url';
import react from '@vitejs/plugin-react';
import { defineConfig } from 'vite';

/** The page of `./sitaf run --debug --view`, which the command serves itself, below any path. */
export default defineConfig({
  base: './',
  plugins: [react()],
  resolve: {
    alias: { '@': fileURLToPath(new URL('./src', import.meta.url)) },
  },
  build: {
    target: 'es2022',
    rolldownOptions: { input: 'live.html' },
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 800,
  },
});
