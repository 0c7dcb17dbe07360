import { Text } from '@mantine/core';
import type { ResultSummary as Summary } from '@/shared/api';
import { formatCount, formatTime, plural } from '@/shared/lib/format';
import classes from './results.module.css';
import { VERDICTS, VERDICT_LABELS, countOf } from '@/shared/lib/verdicts';

/** The number of cases for each verdict and the processing times, as in the paper's Fig. 17(a). */
export function ResultSummary({ summary }: { summary: Summary }) {
  const time = summary.processingTime;
  return (
    <>
      <div className={classes.summaries}>
        <dl className={classes.summary} aria-label="Verdicts">
          <Fact name="Total" value={formatCount(summary.total)} />
          {VERDICTS.map((verdict) => (
            <Fact
              key={verdict}
              name={VERDICT_LABELS[verdict].label}
              value={formatCount(countOf(summary, verdict))}
            />
          ))}
        </dl>
        <dl className={classes.summary} aria-label="Processing time of the component">
          <Fact name="Min" value={formatTime(time?.min)} />
          <Fact name="Max" value={formatTime(time?.max)} />
          <Fact name="Average" value={formatTime(time?.average)} />
          <Fact name="Std deviation" value={formatTime(time?.standardDeviation)} />
          {time?.first !== undefined && <Fact name="First call" value={formatTime(time.first)} />}
        </dl>
      </div>
      {time?.first !== undefined && (
        <Text size="sm" c="dimmed">
          The other times leave out the first call of the process, which also loads and compiles
          code.
        </Text>
      )}
      {summary.unjudged > 0 && (
        <Text size="sm" c="dimmed">
          {plural(summary.unjudged, 'case')} passed without a check: there is no expected value and
          no post-condition.
        </Text>
      )}
      {summary.byError > 0 && (
        <Text size="sm" c="dimmed">
          {plural(summary.byError, 'case')} passed by an exception, which says nothing about values.
        </Text>
      )}
    </>
  );
}

function Fact({ name, value }: { name: string; value: string }) {
  return (
    <div>
      <dt>{name}</dt>
      <dd>{value}</dd>
    </div>
  );
}
