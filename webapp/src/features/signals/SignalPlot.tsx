import { Button, Group, MultiSelect, NativeSelect, Stack, Text } from '@mantine/core';
import { useMemo, useState } from 'react';
import type { CaseSignals } from '@/shared/api';
import { formatCount } from '@/shared/lib/format';
import { UserText } from '@/shared/ui';
import {
  callTime,
  conditionsOf,
  isViolated,
  lanesOf,
  timeRange,
  type Condition,
  type Lane,
  type RecordedReadings,
  type Trajectory,
} from './lanes';
import { SignalLanes } from './SignalLanes';
import classes from './signals.module.css';

/** More lanes do not fit on a screen. */
const MAX_LANES = 8;
const DEFAULT_LANES = 4;

interface SignalPlotProps {
  /** The stored signals of the case; null if there are none. */
  signals: CaseSignals | null;
  /** The recording of the case; null if there is none. */
  readings: RecordedReadings | null;
  /** The results of the trajectory conditions. */
  results: readonly Trajectory[];
  /** The playback of the recording, in simulation time; null without a recording. */
  playback: { time: number; seek: (time: number) => void } | null;
  /** The condition and the seconds after the call to show first. */
  condition?: string | undefined;
  at?: number | undefined;
}

/**
 * The signals of a case over time, with the interval and the outcome of a trajectory condition. Its
 * playhead moves with the replay.
 */
export function SignalPlot({
  signals,
  readings,
  results,
  playback,
  condition: firstCondition,
  at,
}: SignalPlotProps) {
  const conditions = useMemo(() => conditionsOf(signals, results), [signals, results]);
  const lanes = useMemo(
    () => lanesOf(signals, conditions, readings),
    [signals, conditions, readings],
  );
  const range = useMemo(() => timeRange(lanes), [lanes]);
  const [name, setName] = useState(firstCondition);
  const condition = conditions.find((one) => one.name === name) ?? conditions[0];
  const [chosen, setChosen] = useState<string[] | null>(null);
  const [ownTime, setOwnTime] = useState(at ?? condition?.result?.at ?? 0);
  const selected = useMemo(
    () => chosen ?? defaultsOf(condition, lanes),
    [chosen, condition, lanes],
  );
  // The same array while the replay plays, so that the charts are not drawn again.
  const shown = useMemo(
    () => selected.flatMap((wanted) => lanes.find((lane) => lane.name === wanted) ?? []),
    [selected, lanes],
  );
  if (lanes.length === 0) return null;

  const begin = readings ? callTime(signals, readings) : 0;
  const time = playback ? playback.time - begin : ownTime;
  const seek = (wanted: number) => {
    if (playback) playback.seek(begin + wanted);
    else setOwnTime(Math.min(range[1], Math.max(range[0], wanted)));
  };
  return (
    <Stack gap="xs" role="group" aria-label="Signals over time">
      <Group gap="sm" align="end">
        {conditions.length > 0 && (
          <NativeSelect
            label="Condition over time"
            size="xs"
            value={condition?.name}
            data={conditions.map((one) => ({
              value: one.name,
              label: isViolated(one) ? `${one.name} (violated)` : one.name,
            }))}
            onChange={(event) => {
              setName(event.currentTarget.value);
              setChosen(null);
            }}
          />
        )}
        <MultiSelect
          label="Signals"
          size="xs"
          flex="1 1 14rem"
          searchable
          maxValues={MAX_LANES}
          value={selected}
          data={lanes.map((lane) => lane.name)}
          onChange={setChosen}
        />
      </Group>
      {condition && <Outcome condition={condition} onSeek={seek} />}
      <SignalLanes lanes={shown} range={range} condition={condition} time={time} onSeek={seek} />
      <Text size="xs" c="dimmed">
        {signals ? 'Time: seconds after the call. ' : 'Time: seconds from the begin. '}
        Click or drag in the plot, or use the arrow keys, to move the replay.
        {signals && signals.samples > signals.times.length && (
          <>
            {' '}
            {formatCount(signals.times.length)} of {formatCount(signals.samples)} samples are shown,
            with the minima and maxima of each signal.
          </>
        )}
        {readings && ' Readings that no condition uses are sampled 50 times per second.'}
      </Text>
    </Stack>
  );
}

function defaultsOf(condition: Condition | undefined, lanes: readonly Lane[]): string[] {
  const used = lanes.filter((lane) => condition?.signals.includes(lane.name));
  return (used.length > 0 ? used : lanes).slice(0, DEFAULT_LANES).map(({ name }) => name);
}

/** The interval and the result of a condition; a button moves the replay to that moment. */
function Outcome({ condition, onSeek }: { condition: Condition; onSeek: (time: number) => void }) {
  const { from, to, result } = condition;
  const at = result?.at ?? undefined;
  const violated = isViolated(condition);
  return (
    <Group gap="md">
      <Text size="sm">
        <span className={classes.swatch} aria-hidden>
          <span className={classes.interval} />
        </span>
        Interval: {shortNumber(from)} to {shortNumber(to)} s
      </Text>
      {result && at !== undefined && (
        <>
          <Text size="sm">
            <span className={classes.swatch} aria-hidden>
              <span className={classes.moment} data-violated={violated || undefined} />
            </span>
            <UserText>{condition.name}</UserText>{' '}
            {violated ? 'is violated at' : 'holds, decided at'} {shortNumber(at)} s, margin{' '}
            {shortNumber(Number(result.margin))}
          </Text>
          <Button
            size="compact-xs"
            variant="default"
            onClick={() => {
              onSeek(at);
            }}
          >
            Go to {shortNumber(at)} s
          </Button>
        </>
      )}
    </Group>
  );
}

function shortNumber(value: number): string {
  return String(Number(value.toPrecision(6)));
}
