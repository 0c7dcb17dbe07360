import { useEffect, useState } from 'react';

export interface Playback {
  /** Seconds of simulation time. */
  time: number;
  begin: number;
  end: number;
  running: boolean;
  speed: number;
  toggle: () => void;
  /** Pauses at a time. */
  seek: (time: number) => void;
  setSpeed: (speed: number) => void;
}

/**
 * The playback of a recording. It pauses once at `stopAt` when it is played past it. It starts again when another recording is loaded, or pauses at
 * `startAt` if that is given.
 */
export function usePlayback(
  times: Float32Array,
  autoplay: boolean,
  startAt?: number,
  stopAt?: number,
): Playback {
  const begin = times[0] ?? 0;
  const end = times[times.length - 1] ?? begin;
  const [shown, setShown] = useState(times);
  const first = startAt === undefined ? begin : Math.min(end, Math.max(begin, startAt));
  const [time, setTime] = useState(first);
  const [playing, setPlaying] = useState(autoplay && startAt === undefined);
  const [speed, setSpeed] = useState(1);
  const [leaving, setLeaving] = useState(false);
  if (shown !== times) {
    setShown(times);
    setTime(first);
  }
  if (playing && !leaving && time === stopAt) setPlaying(false);
  const running = playing && time < end;
  useEffect(() => {
    if (!running) return;
    let last = performance.now();
    const tick = (now: number) => {
      // The time of a frame may be slightly before performance.now().
      const passed = Math.max(0, now - last) / 1000;
      last = now;
      setTime((old) => {
        const next = Math.min(end, old + passed * speed);
        return stopAt !== undefined && old < stopAt && next > stopAt ? stopAt : next;
      });
      handle = requestAnimationFrame(tick);
    };
    let handle = requestAnimationFrame(tick);
    return () => {
      cancelAnimationFrame(handle);
    };
  }, [running, speed, end, stopAt]);
  return {
    time,
    begin,
    end,
    running,
    speed,
    toggle() {
      if (!running && time >= end) setTime(begin);
      setLeaving(!running && time === stopAt);
      setPlaying(!running);
    },
    seek(wanted) {
      setLeaving(false);
      setPlaying(false);
      setTime(Math.min(end, Math.max(begin, wanted)));
    },
    setSpeed,
  };
}
