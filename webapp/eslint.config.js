import js from '@eslint/js';
import reactHooks from 'eslint-plugin-react-hooks';
import { defineConfig, globalIgnores } from 'eslint/config';
import tseslint from 'typescript-eslint';

/**
 * Import rules: app may import features and shared, live also the theme of app, features may import shared. Imports between
 * folders use an alias (`@/shared/ui`), so that a rule is a pattern.
 */
function importRule(folder, ...forbidden) {
  return rule(`src/${folder}/**/*.{ts,tsx}`, '^\\.\\./', forbidden);
}

/** Folders of a feature may import from the feature around them. */
function importRuleInFeatures(...forbidden) {
  return rule('src/features/*/*/**/*.{ts,tsx}', '^\\.\\./\\.\\./', forbidden);
}

function rule(files, outside, forbidden) {
  const patterns = [
    {
      regex: outside,
      message: 'Import other folders by alias: @/shared/NAME, @/features/NAME.',
    },
    { regex: '^@/features/[^/]+/', message: 'Import a feature by its index: @/features/NAME.' },
    ...forbidden,
  ];
  return {
    files: [files],
    rules: { 'no-restricted-imports': ['error', { patterns }] },
  };
}

const ONLY_SHARED = {
  regex: '^@/(app|features)(/|$)',
  message: 'Features may only import shared.',
};

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
  importRule('live'),
  importRule('features', ONLY_SHARED),
  importRuleInFeatures(ONLY_SHARED),
  importRule('shared', {
    regex: '^@/(app|features)(/|$)',
    message: 'Shared must not import app or features.',
  }),
);
