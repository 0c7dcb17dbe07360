import { Text } from '@mantine/core';
import { useMemo, type KeyboardEvent, type PointerEvent } from 'react';
import { Chart, UserText } from '@/shared/ui';
import { isViolated, valueAt, type Condition, type Lane } from './lanes';
import { AXIS_HEIGHT, LANE_HEIGHT, LEFT, plotHeight, plotOption, RIGHT } from './option';
import classes from './signals.module.css';

/** An arrow key moves the playhead by this share of the axis. */
const KEY_STEP = 0.01;

interface SignalLanesProps {
  lanes: readonly Lane[];
  range: readonly [from: number, to: number];
  condition: Condition | undefined;
  /** Seconds after the call. */
  time: number;
  onSeek: (time: number) => void;
}

/** Plots of signals below each other, with one time axis and one playhead. */
export function SignalLanes({ lanes, range, condition, time, onSeek }: SignalLanesProps) {
  const names = lanes.map(({ name }) => name).join(', ');
  // A new option draws the chart again, so it must not depend on the time.
  const option = useMemo(() => plotOption(lanes, range), [lanes, range]);
  if (lanes.length === 0) return <Text c="dimmed">No signal is selected.</Text>;
  const [from, to] = range;
  const percent = (at: number) =>
    `${(100 * (Math.min(to, Math.max(from, at)) - from)) / (to - from)}%`;
  const seekTo = (event: PointerEvent<HTMLDivElement>) => {
    const { left, width } = event.currentTarget.getBoundingClientRect();
    if (width > 0) onSeek(from + ((event.clientX - left) / width) * (to - from));
  };
  const handleKey = (event: KeyboardEvent) => {
    const wanted = keyTarget(event.key, time, range);
    if (wanted === undefined) return;
    event.preventDefault();
    // The replay would move by a frame.
    event.stopPropagation();
    onSeek(Math.min(to, Math.max(from, wanted)));
  };
  const at = condition?.result?.at ?? undefined;
  return (
    <div className={classes.plot}>
      <Chart label={`${names} over time`} option={option} height={plotHeight(lanes.length)} />
      <dl className={classes.titles} aria-label="Signals at this time">
        {lanes.map((lane, index) => (
          <div key={lane.name} style={{ top: index * LANE_HEIGHT }}>
            <dt>
              <UserText>{lane.name}</UserText>
            </dt>
            <dd>{formatValue(lane, time)}</dd>
          </div>
        ))}
      </dl>
      <div
        className={classes.overlay}
        style={{ left: LEFT, right: RIGHT, bottom: AXIS_HEIGHT }}
        role="slider"
        tabIndex={0}
        aria-label="Time in the plot"
        aria-valuemin={from}
        aria-valuemax={to}
        aria-valuenow={time}
        aria-valuetext={`${time.toFixed(3)} s`}
        onKeyDown={handleKey}
        onPointerDown={(event) => {
          event.currentTarget.setPointerCapture(event.pointerId);
          seekTo(event);
        }}
        onPointerMove={(event) => {
          if (event.buttons !== 0) seekTo(event);
        }}
      >
        {condition && (
          <div
            className={classes.interval}
            data-testid="interval"
            style={{
              left: percent(condition.from),
              right: `calc(100% - ${percent(condition.to)})`,
            }}
          />
        )}
        {condition && at !== undefined && (
          <div
            className={classes.moment}
            data-testid="moment"
            data-violated={isViolated(condition) || undefined}
            style={{ left: percent(at) }}
          />
        )}
        <div className={classes.playhead} data-testid="playhead" style={{ left: percent(time) }} />
      </div>
    </div>
  );
}

function keyTarget(
  key: string,
  time: number,
  [from, to]: readonly [number, number],
): number | undefined {
  const step = (to - from) * KEY_STEP;
  switch (key) {
    case 'ArrowLeft':
    case 'ArrowDown':
      return time - step;
    case 'ArrowRight':
    case 'ArrowUp':
      return time + step;
    case 'PageDown':
      return time - 10 * step;
    case 'PageUp':
      return time + 10 * step;
    case 'Home':
      return from;
    case 'End':
      return to;
    default:
      return undefined;
  }
}

function formatValue(lane: Lane, time: number): string {
  const value = valueAt(lane, time);
  if (value === undefined) return '–';
  const number = value === null ? 'not finite' : String(Number(value.toPrecision(6)));
  return lane.unit === '' ? number : `${number} ${lane.unit}`;
}
