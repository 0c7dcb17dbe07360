import { Button, Checkbox, Group, NativeSelect, Slider, Stack, Text } from '@mantine/core';
import { useEffect, useRef, useState, type KeyboardEvent, type ReactNode } from 'react';
import { Readings, ReadingsTable } from './Readings';
import { frameAt, type Recording } from './recording';
import classes from './replay.module.css';
import { StageView } from './StageView';
import { usePlayback, type Playback } from './usePlayback';

const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4] as const;

interface PlayerProps {
  recording: Recording;
  /** What is to be seen, in words. */
  label: string;
  /** What else is known of the case; stands beside the scene. */
  facts?: ReactNode;
  /** Called when the recording has come to its end. */
  onEnd?: (() => void) | undefined;
}

/** Plays a recording: the scene, the time, and what the devices read then. */
export function Player({ recording, label, facts, onEnd }: PlayerProps) {
  // Nothing moves by itself before those who asked for calm.
  const [autoplay] = useState(() => !window.matchMedia('(prefers-reduced-motion: reduce)').matches);
  const playback = usePlayback(recording.times, autoplay);
  const [body, setBody] = useState<string | null>(null);
  const [following, setFollowing] = useState(false);
  const frame = frameAt(recording, playback.time);
  const ended = playback.time >= playback.end;
  const tell = useRef(onEnd);
  useEffect(() => {
    tell.current = onEnd;
  }, [onEnd]);
  useEffect(() => {
    if (ended) tell.current?.();
  }, [ended, recording]);

  function act(event: KeyboardEvent) {
    const own = event.target instanceof Element && event.target.closest(OWN_KEYS) !== null;
    if (own || event.ctrlKey || event.altKey || event.metaKey) return;
    if (steer(event.key, playback, recording, frame)) event.preventDefault();
  }

  return (
    <Stack gap="md">
      <div
        className={facts ? classes.beside : classes.alone}
        role="group"
        aria-label="Replay"
        tabIndex={0}
        onKeyDown={act}
      >
        <Stack gap="xs">
          <StageView
            recording={recording}
            time={playback.time}
            following={following && body !== null}
            label={label}
            onReady={setBody}
          />
          <Controls recording={recording} playback={playback} frame={frame} />
          <Group gap="lg">
            <NativeSelect
              aria-label="Speed"
              size="xs"
              w={110}
              value={String(playback.speed)}
              data={SPEEDS.map((speed) => ({ value: String(speed), label: `× ${speed}` }))}
              onChange={(event) => {
                playback.setSpeed(Number(event.currentTarget.value));
              }}
            />
            <Checkbox
              size="sm"
              label={
                body === null ? 'Camera follows (nothing moves about)' : `Camera follows ${body}`
              }
              disabled={body === null}
              checked={following && body !== null}
              onChange={(event) => {
                setFollowing(event.currentTarget.checked);
              }}
            />
          </Group>
          <Text size="xs" c="dimmed">
            Space plays and pauses, comma and full stop go a frame back and on, Home and End to the
            beginning and the end. Drag turns the view, the wheel brings it nearer.
          </Text>
          <Readings recording={recording} frame={frame} />
        </Stack>
        {facts}
      </div>
      <ReadingsTable recording={recording} />
    </Stack>
  );
}

/** Whatever takes these keys itself. */
const OWN_KEYS = 'button, input, select, summary, a, [role="slider"]';

function steer(key: string, playback: Playback, { times }: Recording, frame: number): boolean {
  switch (key) {
    case ' ':
      playback.toggle();
      return true;
    case ',':
      playback.seek(before(times, frame, playback.time));
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

/** The time of the frame before; between two frames, of the one that was last. */
function before(times: Float32Array, frame: number, time: number): number {
  const at = times[frame] ?? 0;
  return time > at ? at : (times[frame - 1] ?? at);
}

function Controls({
  recording: { times },
  playback,
  frame,
}: {
  recording: Recording;
  playback: Playback;
  frame: number;
}) {
  const { time, begin, end, running } = playback;
  const still = end <= begin;
  return (
    <Group gap="sm">
      <Button size="xs" w={80} disabled={still} onClick={playback.toggle}>
        {running ? 'Pause' : 'Play'}
      </Button>
      <Button
        size="xs"
        variant="default"
        aria-label="One frame back"
        disabled={still}
        onClick={() => {
          playback.seek(before(times, frame, time));
        }}
      >
        ‹
      </Button>
      <Button
        size="xs"
        variant="default"
        aria-label="One frame on"
        disabled={still}
        onClick={() => {
          playback.seek(times[frame + 1] ?? end);
        }}
      >
        ›
      </Button>
      <Slider
        flex="1 1 10rem"
        thumbLabel="Time"
        thumbProps={{ 'aria-valuetext': `${formatSeconds(time - begin)} s` }}
        label={null}
        disabled={still}
        min={0}
        max={still ? 1 : end - begin}
        step={0.001}
        value={time - begin}
        onChange={(value) => {
          playback.seek(begin + value);
        }}
      />
      <Text size="sm" className={classes.clock ?? ''} data-testid="clock">
        {formatSeconds(time - begin)} of {formatSeconds(end - begin)} s
      </Text>
    </Group>
  );
}

function formatSeconds(seconds: number): string {
  return seconds.toFixed(2);
}
