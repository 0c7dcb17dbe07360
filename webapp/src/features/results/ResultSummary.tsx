import { Stack, Text } from '@mantine/core';
import type { ResultSummary as Summary } from '@/shared/api';
import { formatCount, formatTime, formatUnit, plural } from '@/shared/lib/format';
import classes from './results.module.css';
import { VERDICTS, VERDICT_WORDS, countOf } from '@/shared/lib/verdicts';

/** The head of the paper's Fig. 17(a): how many cases of each verdict, and the times of those that ran. */
export function ResultSummary({ summary }: { summary: Summary }) {
  const time = summary.processingTime;
  const unit = formatUnit(time?.unit);
  return (
    <Stack gap="xs">
      <dl className={classes.summary} aria-label="Verdicts">
        <Fact name="Total" value={formatCount(summary.total)} />
        {VERDICTS.map((verdict) => (
          <Fact
            key={verdict}
            name={VERDICT_WORDS[verdict].label}
            value={formatCount(countOf(summary, verdict))}
          />
        ))}
      </dl>
      <dl className={classes.summary} aria-label="Processing time of the component">
        <Fact name={`Min (${unit})`} value={formatTime(time?.min)} />
        <Fact name={`Max (${unit})`} value={formatTime(time?.max)} />
        <Fact name={`Average (${unit})`} value={formatTime(time?.average)} />
        <Fact name={`Std deviation (${unit})`} value={formatTime(time?.standardDeviation)} />
      </dl>
      {summary.unjudged > 0 && (
        <Text size="sm" c="dimmed">
          {plural(summary.unjudged, 'case')} passed without being judged: no expected value, no
          post-condition.
        </Text>
      )}
    </Stack>
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
