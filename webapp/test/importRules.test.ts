// @vitest-environment node
import { ESLint } from 'eslint';
import { expect, test } from 'vitest';

const RULE = 'no-restricted-imports';
const eslint = new ESLint({
  ruleFilter: ({ ruleId }) => ruleId === RULE,
  // The rule needs no types, which take seconds to load.
  overrideConfig: {
    files: ['**/*.{ts,tsx}'],
    languageOptions: { parserOptions: { projectService: false } },
  },
});

/** Whether the lint rules allow a file to import a module. */
async function mayImport(file: string, module: string): Promise<boolean> {
  const [report] = await eslint.lintText(`import '${module}';\n`, { filePath: file });
  const messages = report?.messages ?? [];
  expect(messages.filter((message) => message.fatal)).toEqual([]);
  return messages.every((message) => message.ruleId !== RULE);
}

test.each([
  ['src/features/builds/state.ts', '@/features/results'],
  ['src/features/builds/state.ts', '../results'],
  ['src/features/builds/state.ts', '@/app/router'],
  ['src/features/models/values/NumberLine.tsx', '../../results'],
  ['src/features/models/values/NumberLine.tsx', '@/features/results'],
  ['src/shared/lib/format.ts', '@/features/results'],
  ['src/shared/lib/format.ts', '@/app/theme'],
  ['src/shared/lib/format.ts', '../../features/results'],
  ['src/app/theme.ts', '@/features/results/queries'],
])('%s may not import %s', async (file, module) => {
  expect(await mayImport(file, module)).toBe(false);
});

test.each([
  ['src/app/theme.ts', '@/features/results'],
  ['src/app/theme.ts', '@/shared/ui'],
  ['src/features/builds/state.ts', '@/shared/api'],
  ['src/features/builds/state.ts', './queries'],
  ['src/features/models/values/NumberLine.tsx', '../document'],
  ['src/shared/lib/format.ts', '@/shared/lib/visible'],
])('%s may import %s', async (file, module) => {
  expect(await mayImport(file, module)).toBe(true);
});
