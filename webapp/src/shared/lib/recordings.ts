import type { RecordedCases } from '@/shared/api';

/** Suites of up to so many cases are recorded where nobody says otherwise: `RecordedCases` of the server. */
const FEW = 100;

/** Of which cases it is recorded what moves; empty where the server is to decide. */
export type RecordingsWish = RecordedCases | '';

export const RECORDINGS: readonly { value: RecordingsWish; label: string }[] = [
  { value: '', label: `all of up to ${FEW} cases, none of more` },
  { value: 'ALL', label: 'all cases' },
  { value: 'FAILED', label: 'cases that fail or end in an error' },
  { value: 'NONE', label: 'none' },
];

/** Such as `cases that fail or end in an error`. */
export function recordingsInWords(wish: RecordingsWish): string {
  return RECORDINGS.find(({ value }) => value === wish)?.label ?? '';
}
