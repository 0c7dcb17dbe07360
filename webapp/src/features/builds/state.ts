import type { Build, BuildState } from '@/shared/api';
import { labelOfState } from '@/shared/lib/buildStates';

const FINISHED: readonly BuildState[] = ['DONE', 'FAILED', 'CANCELLED'];

/** Whether the build has reached a final state. */
export function isFinished(build: Build): boolean {
  return FINISHED.includes(build.state);
}

/** The signs make the tones readable without colour. */
const SIGNS = { waiting: '…', active: '▸', good: '✓', bad: '✕', neutral: '·' } as const;

/** The status of a build as text; the tone selects its colour. */
export interface BuildStatus {
  label: string;
  sign: string;
  tone: 'waiting' | 'active' | 'good' | 'bad' | 'neutral';
}

const TONES: Partial<Record<BuildState, BuildStatus['tone']>> = {
  QUEUED: 'waiting',
  LEASED: 'active',
  PREPARING: 'active',
  COMPILING: 'active',
  RUNNING: 'active',
  UPLOADING: 'active',
  FAILED: 'bad',
};

/** Whether the verdicts cannot be trusted. Such a build never counts as passed. */
export function isSuspect({ suspicions }: Build): boolean {
  return suspicions.length > 0;
}

/** The status of a finished build is its result. A build that could not run is not a failed test. */
export function statusOf(build: Build): BuildStatus {
  const { label, tone } = labelOf(build);
  return { label, tone, sign: SIGNS[tone] };
}

function labelOf(build: Build): Omit<BuildStatus, 'sign'> {
  if (build.state === 'DONE' && build.summary) {
    if (isSuspect(build)) return { label: 'Suspect', tone: 'bad' };
    const { total, pass, fail, error } = build.summary;
    if (pass === total) return { label: 'All passed', tone: 'good' };
    if (fail + error > 0) return { label: 'Cases failed', tone: 'bad' };
    return { label: 'Not all executed', tone: 'waiting' };
  }
  return { label: labelOfState(build.state), tone: TONES[build.state] ?? 'neutral' };
}

/** Executed cases in percent, 0 to 100. */
export function progressOf(build: Build): number {
  return build.casesTotal > 0 ? (100 * build.casesDone) / build.casesTotal : 0;
}

/** The estimate needs some cases that ended. */
const MIN_ELAPSED_S = 5;

/**
 * The seconds that the other cases of a running build will take if they take as long on average;
 * null if that is not known yet, or less than one.
 */
export function secondsLeft(build: Build, now: Date): number | null {
  const { casesDone, casesTotal, started } = build;
  if (build.state !== 'RUNNING' || started === undefined || casesDone === 0) return null;
  const elapsed = (now.getTime() - new Date(started).getTime()) / 1000;
  if (elapsed < MIN_ELAPSED_S) return null;
  const left = (elapsed / casesDone) * (casesTotal - casesDone);
  return left < 1 ? null : left;
}
