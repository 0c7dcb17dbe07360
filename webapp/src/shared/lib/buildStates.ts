import type { BuildState } from '@/shared/api';

/** The states of a build, as shown to users. */
const BUILD_STATES: Record<BuildState, string> = {
  QUEUED: 'Queued',
  LEASED: 'Assigned to an agent',
  PREPARING: 'Preparing',
  COMPILING: 'Compiling',
  RUNNING: 'Running',
  UPLOADING: 'Uploading the result',
  DONE: 'Done',
  FAILED: 'Could not run',
  CANCELLED: 'Cancelled',
};

export const STATES = Object.keys(BUILD_STATES) as BuildState[];

/** Unknown states of a newer server are shown unchanged. */
export function labelOfState(state: string): string {
  return state in BUILD_STATES ? BUILD_STATES[state as BuildState] : state;
}
