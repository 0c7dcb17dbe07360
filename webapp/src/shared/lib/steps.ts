import type { StepResult } from '@/shared/api';

/** Whether a step decides the verdict of its case: the first one that did not pass. */
export function decides({ verdict, afterFailure, at }: StepResult): boolean {
  // A step that was not reached does not.
  return verdict !== 'PASS' && !afterFailure && (verdict !== 'DONT' || at !== undefined);
}
