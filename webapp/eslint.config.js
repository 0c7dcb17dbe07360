import js from '@eslint/js';
import reactHooks from 'eslint-plugin-react-hooks';
import { defineConfig, globalIgnores } from 'eslint/config';
import tseslint from 'typescript-eslint';

/**
 * The walls: app imports features, features import shared, nothing the other way and no feature
 * another. A room is left by its alias only (`@/shared/ui`), so that a wall is a pattern.
 */
function wall(room, ...forbidden) {
  const patterns = [
    { regex: '^\\.\\./', message: 'Leave a room by its alias: @/shared/ROOM, @/features/NAME.' },
    { regex: '^@/features/[^/]+/', message: 'Import a feature by its index: @/features/NAME.' },
    ...forbidden,
  ];
  return {
    files: [`src/${room}/**/*.{ts,tsx}`],
    rules: { 'no-restricted-imports': ['error', { patterns }] },
  };
}

export default defineConfig(
  globalIgnores(['dist/', 'target/', 'src/shared/api/schema.d.ts']),
  js.configs.recommended,
  {
    files: ['**/*.{ts,tsx}'],
    extends: [tseslint.configs.strictTypeChecked, reactHooks.configs.flat['recommended-latest']],
    languageOptions: { parserOptions: { projectService: true } },
    rules: {
      '@typescript-eslint/consistent-type-imports': 'error',
      '@typescript-eslint/restrict-template-expressions': ['error', { allowNumber: true }],
      // Nulls from the wire stand where the document says "absent": `!= null` is meant.
      '@typescript-eslint/no-unnecessary-condition': 'off',
    },
  },
  {
    files: ['scripts/**/*.mjs', '*.config.js'],
    languageOptions: { globals: { process: 'readonly', console: 'readonly' } },
  },
  wall('app'),
  wall('features', {
    regex: '^@/(app|features)(/|$)',
    message: 'A feature imports shared only; app puts features together.',
  }),
  wall('shared', {
    regex: '^@/(app|features)(/|$)',
    message: 'Shared knows neither app nor features.',
  }),
);
