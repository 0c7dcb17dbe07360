import type { Build } from '@/shared/api';
import classes from './builds.module.css';
import { statusOf } from './state';

export function BuildStatus({ build }: { build: Build }) {
  const { label, sign, tone } = statusOf(build);
  return (
    <span className={classes.status} data-tone={tone}>
      <span aria-hidden>{sign}</span> {label}
    </span>
  );
}
