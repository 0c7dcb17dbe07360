import { UserText } from '@/shared/ui';
import classes from './replay.module.css';

/** A step of a sequence on the time axis of a recording. */
export interface StepMark {
  /** Number of the step, from 1. */
  no: number;
  /** Simulation time at which it began. */
  time: number;
  name: string;
  /** The verdict in words. */
  verdict: string;
  tone: 'pass' | 'fail' | 'none';
  /** Whether it is the first step that did not pass. */
  decides: boolean;
}

interface StepMarksProps {
  marks: readonly StepMark[];
  begin: number;
  end: number;
  time: number;
  onSeek: (time: number) => void;
}

/** The steps below the time axis. Steps that begin at the same time are one mark. */
export function StepMarks({ marks, begin, end, time, onSeek }: StepMarksProps) {
  const groups = new Map<string, StepMark[]>();
  for (const mark of marks) {
    const key = mark.time.toFixed(4);
    groups.set(key, [...(groups.get(key) ?? []), mark]);
  }
  const current = marks.findLast((mark) => mark.time <= time + 1e-4);
  return (
    <div>
      <div className={classes.marks} role="group" aria-label="Steps on the time axis">
        {[...groups.values()].map((group) => {
          const [first] = group;
          const last = group.at(-1);
          if (!first || !last) return null;
          const share = end > begin ? (first.time - begin) / (end - begin) : 0;
          const worst =
            group.find(({ decides }) => decides) ??
            group.find(({ tone }) => tone === 'fail') ??
            first;
          return (
            <button
              key={first.no}
              type="button"
              className={classes.mark}
              style={{ insetInlineStart: `${Math.min(1, Math.max(0, share)) * 100}%` }}
              data-tone={worst.tone}
              data-decides={worst.decides || undefined}
              title={group.map(describe).join('\n')}
              aria-label={group.map(describe).join('; ')}
              onClick={() => {
                onSeek(Math.min(end, first.time));
              }}
            >
              {first.no === last.no ? first.no : `${first.no}–${last.no}`}
            </button>
          );
        })}
      </div>
      <div className={classes.step} data-testid="step">
        {current ? <UserText>{describe(current)}</UserText> : 'Before the first step'}
      </div>
    </div>
  );
}

function describe({ no, name, verdict }: StepMark): string {
  return `Step ${no} ${name}: ${verdict}`;
}
