import type { RecordedCases } from '@/shared/api';

/** By default, suites of up to this many cases are recorded: `RecordedCases` of the server. */
const DEFAULT_LIMIT = 100;

/** The cases to record; empty for the default of the server. */
export type RecordingsOption = RecordedCases | '';

export const RECORDINGS: readonly { value: RecordingsOption; label: string }[] = [
  { value: '', label: `all cases if there are at most ${DEFAULT_LIMIT}` },
  { value: 'ALL', label: 'all cases' },
  { value: 'FAILED', label: 'failed cases and errors' },
  { value: 'NONE', label: 'none' },
];

/** Such as `failed cases and errors`. */
export function labelOfRecordings(option: RecordingsOption): string {
  return RECORDINGS.find(({ value }) => value === option)?.label ?? '';
}
