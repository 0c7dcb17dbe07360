import type { Verdict } from '@/shared/api';

export const VERDICTS: readonly Verdict[] = ['PASS', 'FAIL', 'ERROR', 'DONT'];

/** The labels of the verdicts. The sign makes them readable without colour. */
export const VERDICT_LABELS: Record<Verdict, { label: string; sign: string }> = {
  PASS: { label: 'Pass', sign: '✓' },
  FAIL: { label: 'Fail', sign: '✕' },
  ERROR: { label: 'Error', sign: '!' },
  DONT: { label: 'Not executed', sign: '–' },
};

/** Distinguishable for colour-blind users on light and dark backgrounds. */
export const VERDICT_COLOURS = {
  PASS: '#2f9e6b',
  FAIL: '#d9503f',
  ERROR: '#8f3fb0',
  DONT: '#b98a1f',
} as const;

/** The number of cases for each verdict. */
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
