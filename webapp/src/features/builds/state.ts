import type { Build, BuildState } from '@/shared/api';
import { buildStateInWords } from '@/shared/lib/buildStates';

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

const TONES: Partial<Record<BuildState, Standing['tone']>> = {
  QUEUED: 'waiting',
  LEASED: 'active',
  PREPARING: 'active',
  COMPILING: 'active',
  RUNNING: 'active',
  UPLOADING: 'active',
  FAILED: 'bad',
};

/** Whether the verdicts cannot be trusted; such a build never counts as passed. */
export function isSuspect({ suspicions }: Build): boolean {
  return suspicions.length > 0;
}

/** A build that is done says what came of it; one that could not run is not a failed test. */
export function standingOf(build: Build): Standing {
  if (build.state === 'DONE' && build.summary) {
    if (isSuspect(build)) return { label: 'Suspect', tone: 'bad' };
    const { total, pass, fail, error } = build.summary;
    if (pass === total) return { label: 'All passed', tone: 'good' };
    if (fail + error > 0) return { label: 'Cases failed', tone: 'bad' };
    return { label: 'Not all executed', tone: 'waiting' };
  }
  return { label: buildStateInWords(build.state), tone: TONES[build.state] ?? 'neutral' };
}

/** Executed cases in percent, 0 to 100. */
export function progressOf(build: Build): number {
  return build.casesTotal > 0 ? (100 * build.casesDone) / build.casesTotal : 0;
}
