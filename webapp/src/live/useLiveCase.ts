import { useEffect, useState } from 'react';
import { readRecording, type Recording } from '@/features/replay';

/** A case that `./sitaf run --debug --view` runs. */
export interface WatchedCase {
  activity: string;
  model: string;
  no: number;
  inputs: { name: string; literal: string }[];
  ended: boolean;
}

/** What the page knows; `lost` when the command no longer answers. */
export interface LiveState {
  watched: WatchedCase | null;
  recording: Recording | null;
  lost: boolean;
  failure: string | null;
}

const REFRESH_MS = 300;
/** More failed requests in a row mean that the command has ended. */
const MAX_FAILURES = 3;
const BEGIN: LiveState = { watched: null, recording: null, lost: false, failure: null };

/** Asks the command for the state of the case until the command ends. */
export function useLiveCase(): LiveState {
  const [state, setState] = useState(BEGIN);
  useEffect(() => {
    let stopped = false;
    let timer: ReturnType<typeof setTimeout> | undefined;
    let tag = '';
    let failures = 0;

    async function ask() {
      const watched = (await (await found('case.json')).json()) as WatchedCase;
      const motion = await found('motion.glb', tag === '' ? {} : { 'If-None-Match': tag });
      const changed = motion.status === 200;
      const recording = changed ? readRecording(await motion.arrayBuffer()) : null;
      if (changed) tag = motion.headers.get('ETag') ?? '';
      if (stopped) return;
      setState((old) => ({ ...old, watched, recording: recording ?? old.recording, lost: false }));
    }

    async function follow() {
      try {
        await ask();
        failures = 0;
      } catch (cause) {
        failures += 1;
        if (!stopped && failures >= MAX_FAILURES) {
          const unreadable = cause instanceof Error && !(cause instanceof TypeError);
          setState((old) => ({ ...old, lost: true, failure: unreadable ? cause.message : null }));
          return;
        }
      }
      if (!stopped) timer = setTimeout(() => void follow(), REFRESH_MS);
    }

    void follow();
    return () => {
      stopped = true;
      clearTimeout(timer);
    };
  }, []);
  return state;
}

async function found(path: string, headers: Record<string, string> = {}): Promise<Response> {
  const answer = await fetch(path, { headers });
  if (!answer.ok && answer.status !== 304) {
    throw new Error(`The command answers ${answer.status} to ${path}.`);
  }
  return answer;
}
