import js from '@eslint/js';
import reactHooks from 'eslint-plugin-react-hooks';
import { defineConfig, globalIgnores } from 'eslint/config';
import tseslint from 'typescript-eslint';

/**
 * Import rules: app may import features and shared, features may import shared. Imports between
 * folders use an alias (`@/shared/ui`), so that a rule is a pattern.
 */
function importRule(folder, ...forbidden) {
  const patterns = [
    {
      regex: '^\\.\\./',
      message: 'Import other folders by alias: @/shared/NAME, @/features/NAME.',
    },
    { regex: '^@/features/[^/]+/', message: 'Import a feature by its index: @/features/NAME.' },
    ...forbidden,
  ];
  return {
    files: [`src/${folder}/**/*.{ts,tsx}`],
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
      // JSON has null where the OpenAPI document says "absent".
      '@typescript-eslint/no-unnecessary-condition': 'off',
    },
  },
  {
    files: ['scripts/**/*.mjs', '*.config.js'],
    languageOptions: { globals: { process: 'readonly', console: 'readonly' } },
  },
  importRule('app'),
  importRule('features', {
    regex: '^@/(app|features)(/|$)',
    message: 'Features may only import shared.',
  }),
  importRule('shared', {
    regex: '^@/(app|features)(/|$)',
    message: 'Shared must not import app or features.',
  }),
);
