import type { Build } from '@/shared/api';
import classes from './builds.module.css';
import { standingOf } from './state';

const SIGNS = { waiting: '…', active: '▸', good: '✓', bad: '✕', neutral: '·' } as const;

export function BuildStanding({ build }: { build: Build }) {
  const { label, tone } = standingOf(build);
  return (
    <span className={classes.standing} data-tone={tone}>
      <span aria-hidden>{SIGNS[tone]}</span> {label}
    </span>
  );
}
