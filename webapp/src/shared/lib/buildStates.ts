import type { BuildState } from '@/shared/api';

/** What a build is doing, in words. */
const BUILD_STATES: Record<BuildState, string> = {
  QUEUED: 'Queued',
  LEASED: 'Taken by an agent',
  PREPARING: 'Preparing',
  COMPILING: 'Compiling',
  RUNNING: 'Running',
  UPLOADING: 'Uploading the result',
  DONE: 'Done',
  FAILED: 'Could not run',
  CANCELLED: 'Cancelled',
};

/** A newer server may know states that this portal does not; they are shown as they are. */
export function buildStateInWords(state: string): string {
  return state in BUILD_STATES ? BUILD_STATES[state as BuildState] : state;
}
