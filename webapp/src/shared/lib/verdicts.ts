import type { Verdict } from '@/shared/api';

export const VERDICTS: readonly Verdict[] = ['PASS', 'FAIL', 'ERROR', 'DONT'];

/** The paper's verdicts in words, with a sign so that colour never speaks alone. */
export const VERDICT_WORDS: Record<Verdict, { label: string; sign: string }> = {
  PASS: { label: 'Pass', sign: '✓' },
  FAIL: { label: 'Fail', sign: '✕' },
  ERROR: { label: 'Error', sign: '!' },
  DONT: { label: 'Not executed', sign: '–' },
};

/** Apart from each other for the colour-blind, and visible on light and dark ground. */
export const VERDICT_COLOURS = {
  PASS: '#2f9e6b',
  FAIL: '#d9503f',
  ERROR: '#8f3fb0',
  DONT: '#b98a1f',
} as const;

/** How many cases of each verdict. */
interface Counts {
  pass: number;
  fail: number;
  error: number;
  dont: number;
}

export function countOf(summary: Counts, verdict: Verdict): number {
  switch (verdict) {
    case 'PASS':
      return summary.pass;
    case 'FAIL':
      return summary.fail;
    case 'ERROR':
      return summary.error;
    case 'DONT':
      return summary.dont;
  }
}
