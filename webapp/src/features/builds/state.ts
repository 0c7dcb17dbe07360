import type { Build, BuildState } from '@/shared/api';

const FINISHED: readonly BuildState[] = ['DONE', 'FAILED', 'CANCELLED'];

/** Whether nothing about the build changes any more. */
export function isFinished(build: Build): boolean {
  return FINISHED.includes(build.state);
}

/** How a build stands, in a word and a tone; the tone never speaks alone. */
export interface Standing {
  label: string;
  tone: 'waiting' | 'active' | 'good' | 'bad' | 'neutral';
}

const STANDINGS: Record<BuildState, Standing> = {
  QUEUED: { label: 'Queued', tone: 'waiting' },
  LEASED: { label: 'Taken by an agent', tone: 'active' },
  PREPARING: { label: 'Preparing', tone: 'active' },
  COMPILING: { label: 'Compiling', tone: 'active' },
  RUNNING: { label: 'Running', tone: 'active' },
  UPLOADING: { label: 'Uploading the result', tone: 'active' },
  DONE: { label: 'Done', tone: 'neutral' },
  FAILED: { label: 'Could not run', tone: 'bad' },
  CANCELLED: { label: 'Cancelled', tone: 'neutral' },
};

/** A build that is done says what came of it; one that could not run is not a failed test. */
export function standingOf(build: Build): Standing {
  if (build.state === 'DONE' && build.summary) {
    const { total, pass, fail, error } = build.summary;
    if (pass === total) return { label: 'All passed', tone: 'good' };
    if (fail + error > 0) return { label: 'Cases failed', tone: 'bad' };
    return { label: 'Not all executed', tone: 'waiting' };
  }
  // A newer server may know states that this portal does not.
  return STANDINGS[build.state] ?? { label: build.state, tone: 'neutral' };
}

/** Executed cases in percent, 0 to 100. */
export function progressOf(build: Build): number {
  return build.casesTotal > 0 ? (100 * build.casesDone) / build.casesTotal : 0;
}
