import { useEffect, useState } from 'react';

export interface Playback {
  /** Seconds of simulation time. */
  time: number;
  begin: number;
  end: number;
  running: boolean;
  speed: number;
  toggle: () => void;
  /** Stops, and shows a time. */
  seek: (time: number) => void;
  setSpeed: (speed: number) => void;
}

/** Lets the time of a recording pass, from its beginning; another recording begins anew. */
export function usePlayback(times: Float32Array, autoplay: boolean): Playback {
  const begin = times[0] ?? 0;
  const end = times[times.length - 1] ?? begin;
  const [shown, setShown] = useState(times);
  const [time, setTime] = useState(begin);
  const [playing, setPlaying] = useState(autoplay);
  const [speed, setSpeed] = useState(1);
  if (shown !== times) {
    setShown(times);
    setTime(begin);
  }
  const running = playing && time < end;
  useEffect(() => {
    if (!running) return;
    let before = performance.now();
    const tick = (now: number) => {
      // The clock of frames may lie a little before that of the page.
      const passed = Math.max(0, now - before) / 1000;
      before = now;
      setTime((old) => Math.min(end, old + passed * speed));
      handle = requestAnimationFrame(tick);
    };
    let handle = requestAnimationFrame(tick);
    return () => {
      cancelAnimationFrame(handle);
    };
  }, [running, speed, end]);
  return {
    time,
    begin,
    end,
    running,
    speed,
    toggle() {
      if (!running && time >= end) setTime(begin);
      setPlaying(!running);
    },
    seek(wanted) {
      setPlaying(false);
      setTime(Math.min(end, Math.max(begin, wanted)));
    },
    setSpeed,
  };
}
