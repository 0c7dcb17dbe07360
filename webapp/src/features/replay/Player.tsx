import { Button, Checkbox, Group, NativeSelect, Slider, Stack, Text } from '@mantine/core';
import { useEffect, useRef, useState, type KeyboardEvent, type ReactNode } from 'react';
import type { Verdict } from '@/shared/api';
import { EventMarks, type EventMark } from './EventMarks';
import { Readings, ReadingsTable } from './Readings';
import { frameAt, type Recording } from './recording';
import classes from './replay.module.css';
import { StageView } from './StageView';
import { StepMarks, type StepMark } from './StepMarks';
import { usePlayback, type Playback } from './usePlayback';

const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4] as const;

interface PlayerProps {
  recording: Recording;
  /** The verdict of the case, if it is known. */
  verdict?: Verdict | undefined;
  /** Describes the scene for screen readers. */
  label: string;
  /** The result of the case, shown next to the scene. */
  facts?: ReactNode;
  /** Called at the end of the recording. */
  onEnd?: (() => void) | undefined;
  /** The time to show first, instead of playing from the begin. */
  startAt?: number | undefined;
  /** The steps of a sequence. */
  marks?: readonly StepMark[] | undefined;
  /** Faults of devices, and what conditions over time say. */
  events?: readonly EventMark[] | undefined;
  /** More about the case over time, shown below the scene. */
  plot?: ((playback: Playback) => ReactNode) | undefined;
}

/** Plays a recording: the scene, the time and the readings of the devices. */
export function Player({
  recording,
  verdict,
  label,
  facts,
  onEnd,
  startAt,
  marks,
  events,
  plot,
}: PlayerProps) {
  // No autoplay if the user prefers reduced motion.
  const [autoplay] = useState(() => !window.matchMedia('(prefers-reduced-motion: reduce)').matches);
  const playback = usePlayback(recording.times, autoplay, startAt);
  const [body, setBody] = useState<string | null>(null);
  const [following, setFollowing] = useState(true);
  const frame = frameAt(recording, playback.time);
  const ended = playback.time >= playback.end;
  const latestOnEnd = useRef(onEnd);
  useEffect(() => {
    latestOnEnd.current = onEnd;
  }, [onEnd]);
  useEffect(() => {
    if (ended) latestOnEnd.current?.();
  }, [ended, recording]);

  function handleKey(event: KeyboardEvent) {
    const inControl = event.target instanceof Element && event.target.closest(CONTROLS) !== null;
    if (inControl || event.ctrlKey || event.altKey || event.metaKey) return;
    if (handlePlaybackKey(event.key, playback, recording, frame)) event.preventDefault();
  }

  return (
    <Stack gap="sm">
      <div
        className={facts ? classes.withFacts : classes.alone}
        role="group"
        aria-label="Replay"
        tabIndex={0}
        onKeyDown={handleKey}
      >
        <Stack gap="xs">
          <StageView
            recording={recording}
            verdict={verdict}
            time={playback.time}
            following={following && body !== null}
            label={label}
            onReady={setBody}
          />
          <Controls recording={recording} playback={playback} frame={frame}>
            {events && events.length > 0 && (
              <EventMarks
                events={events}
                begin={playback.begin}
                end={playback.end}
                onSeek={playback.seek}
              />
            )}
            {marks && marks.length > 0 && (
              <StepMarks
                marks={marks}
                begin={playback.begin}
                end={playback.end}
                time={playback.time}
                onSeek={playback.seek}
              />
            )}
          </Controls>
          <Group gap="md">
            <NativeSelect
              aria-label="Speed"
              size="xs"
              w={84}
              value={String(playback.speed)}
              data={SPEEDS.map((speed) => ({ value: String(speed), label: `× ${speed}` }))}
              onChange={(event) => {
                playback.setSpeed(Number(event.currentTarget.value));
              }}
            />
            <Checkbox
              size="xs"
              label={body === null ? 'Follow (no moving body)' : `Follow ${body}`}
              disabled={body === null}
              checked={following && body !== null}
              onChange={(event) => {
                setFollowing(event.currentTarget.checked);
              }}
            />
            <Text size="xs" c="dimmed" className={classes.help ?? ''}>
              Space: play or pause. Comma, full stop: previous or next frame. Drag: rotate. Mouse
              wheel: zoom.
            </Text>
          </Group>
          {plot?.(playback)}
        </Stack>
        {facts}
      </div>
      <Readings recording={recording} frame={frame} />
      <ReadingsTable recording={recording} />
    </Stack>
  );
}

/** Elements that handle these keys themselves. */
const CONTROLS = 'button, input, select, summary, a, [role="slider"]';

function handlePlaybackKey(
  key: string,
  playback: Playback,
  { times }: Recording,
  frame: number,
): boolean {
  switch (key) {
    case ' ':
      playback.toggle();
      return true;
    case ',':
      playback.seek(previousFrame(times, frame, playback.time));
      return true;
    case '.':
      playback.seek(times[frame + 1] ?? playback.end);
      return true;
    case 'Home':
      playback.seek(playback.begin);
      return true;
    case 'End':
      playback.seek(playback.end);
      return true;
    default:
      return false;
  }
}

/** The time of the previous frame. */
function previousFrame(times: Float32Array, frame: number, time: number): number {
  const at = times[frame] ?? 0;
  return time > at ? at : (times[frame - 1] ?? at);
}

function Controls({
  recording: { times },
  playback,
  frame,
  children,
}: {
  recording: Recording;
  playback: Playback;
  frame: number;
  /** Shown below the time axis. */
  children?: ReactNode;
}) {
  const { time, begin, end, running } = playback;
  const singleFrame = end <= begin;
  return (
    <Group gap="sm">
      <Button size="xs" w={80} disabled={singleFrame} onClick={playback.toggle}>
        {running ? 'Pause' : 'Play'}
      </Button>
      <Button
        size="xs"
        variant="default"
        aria-label="Previous frame"
        disabled={singleFrame}
        onClick={() => {
          playback.seek(previousFrame(times, frame, time));
        }}
      >
        ‹
      </Button>
      <Button
        size="xs"
        variant="default"
        aria-label="Next frame"
        disabled={singleFrame}
        onClick={() => {
          playback.seek(times[frame + 1] ?? end);
        }}
      >
        ›
      </Button>
      <div className={classes.axis}>
        <Slider
          thumbLabel="Time"
          thumbProps={{ 'aria-valuetext': `${formatSeconds(time - begin)} s` }}
          label={null}
          disabled={singleFrame}
          min={0}
          max={singleFrame ? 1 : end - begin}
          step={0.001}
          value={time - begin}
          onChange={(value) => {
            playback.seek(begin + value);
          }}
        />
        {children}
      </div>
      <Text size="sm" className={classes.clock ?? ''} data-testid="clock">
        {formatSeconds(time - begin)} of {formatSeconds(end - begin)} s
      </Text>
    </Group>
  );
}

function formatSeconds(seconds: number): string {
  return seconds.toFixed(2);
}
