import type { Build } from '@/shared/api';
import classes from './builds.module.css';
import { statusOf } from './state';

const SIGNS = { waiting: '…', active: '▸', good: '✓', bad: '✕', neutral: '·' } as const;

export function BuildStatus({ build }: { build: Build }) {
  const { label, tone } = statusOf(build);
  return (
    <span className={classes.status} data-tone={tone}>
      <span aria-hidden>{SIGNS[tone]}</span> {label}
    </span>
  );
}
