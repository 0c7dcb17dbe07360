import type { Difference } from '@/shared/api';

export const KIND_LABELS: Record<Difference['kind'], string> = {
  value: 'Value',
  error: 'Exception',
  calls: 'Calls',
  commands: 'Commands',
  observed: 'Observation',
  trajectory: 'Motion',
  verdict: 'Verdict',
  coverage_lost: 'Lost coverage',
  slower: 'Slower',
};
