import { fileURLToPath } from 'node:url';
import react from '@vitejs/plugin-react';
import { defineConfig } from 'vitest/config';
import { brotli } from './scripts/brotli.mjs';
import { examples } from './scripts/examples.mjs';
import { shellFirst } from './scripts/shellFirst.mjs';

export default defineConfig({
  plugins: [react(), examples(), shellFirst(), brotli()],
  resolve: {
    alias: { '@': fileURLToPath(new URL('./src', import.meta.url)) },
  },
  build: {
    target: 'es2022',
    // The content security policy allows no data: scripts, styles or fonts.
    assetsInlineLimit: 0,
    rolldownOptions: {
      output: {
        // One file of what nearly all pages need, instead of twenty small ones. What only some need, such as charts and
        // the 3D scene, stays in files of their own.
        codeSplitting: {
          groups: [{ name: 'base', test: /node_modules\/(@mantine|@floating-ui|@tanstack|react)/ }],
        },
      },
    },
    chunkSizeWarningLimit: 800,
  },
  server: {
    host: '127.0.0.1',
    port: 5173,
    proxy: {
      '/api': {
        target: process.env['SITAF_SERVER'] ?? 'http://localhost:8080',
        changeOrigin: true,
        // The server rejects requests of other origins, such as the dev server.
        configure: (proxy) => {
          proxy.on('proxyReq', (request) => {
            request.removeHeader('origin');
          });
        },
      },
    },
  },
  test: {
    environment: 'jsdom',
    include: ['test/**/*.test.{ts,tsx}'],
    setupFiles: ['test/support/setup.ts'],
    testTimeout: 120_000,
    // Files of a worker share the modules of the portal, which take seconds to load. Each test has a server of its own.
    isolate: false,
    pool: 'threads',
    // In jsdom no element has a size, so a popover finds none to focus. The message prints the whole tree of React.
    onConsoleLog: (text) => !text.includes('[@mantine/hooks/use-focus-trap]'),
  },
});
