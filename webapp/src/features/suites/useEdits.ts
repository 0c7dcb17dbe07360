import { useEffect, useRef, useState } from 'react';
import type { Suite } from '@/shared/api';
import { ApiError } from '@/shared/api';
import { useChangeSuite, type ExpectedChange, type SuiteChange } from './queries';

/** The key of an expected value that is being changed. */
export function cellKey(no: number, output: string): string {
  return `${no} ${output}`;
}

/**
 * Sends the changes of a suite one after another, each onto the version that the one before made.
 * What is typed meanwhile waits and goes together. A conflict stops it all: nothing is overwritten.
 */
export function useEdits(suite: Suite) {
  const change = useChangeSuite(suite.id);
  /** What was typed and is not yet stored, by cell; it is shown in the place of what is stored. */
  const [drafts, setDrafts] = useState<ReadonlyMap<string, string>>(new Map());
  const waiting = useRef<Map<string, ExpectedChange>>(new Map());
  const sending = useRef(false);
  const version = useRef(suite.version);
  const [conflict, setConflict] = useState(false);
  useEffect(() => {
    if (!sending.current && !conflict) version.current = suite.version;
  }, [suite.version, conflict]);

  async function send(next: SuiteChange): Promise<boolean> {
    sending.current = true;
    try {
      const changed = await change.mutateAsync({ change: next, version: version.current });
      version.current = changed.version;
      return true;
    } catch (cause) {
      if (cause instanceof ApiError && (cause.status === 412 || cause.status === 409)) {
        setConflict(cause.status === 412);
      }
      return false;
    } finally {
      sending.current = false;
    }
  }

  async function flush() {
    if (sending.current) return;
    while (waiting.current.size > 0) {
      const batch = waiting.current;
      waiting.current = new Map();
      const sent = await send({ kind: 'expected', changes: [...batch.values()] });
      if (!sent) {
        // Kept, so that they can be sent again; newer ones of the same cell win.
        waiting.current = new Map([...batch, ...waiting.current]);
        return;
      }
      setDrafts((old) => new Map([...old].filter(([key]) => waiting.current.has(key))));
    }
  }

  function set(changes: readonly ExpectedChange[]) {
    for (const item of changes) {
      waiting.current.set(cellKey(item.no, item.output ?? ''), item);
    }
    setDrafts(
      (old) =>
        new Map([
          ...old,
          ...changes.map((item): [string, string] => [
            cellKey(item.no, item.output ?? ''),
            item.literal ?? '',
          ]),
        ]),
    );
    void flush();
  }

  function discard() {
    waiting.current = new Map();
    setDrafts(new Map());
    setConflict(false);
    change.reset();
  }

  return {
    drafts,
    set,
    /** Anything but single values; what is typed goes first. */
    apply: async (next: SuiteChange) => {
      await flush();
      return waiting.current.size === 0 && (await send(next));
    },
    conflict,
    discard,
    /** Sends what waits onto what is stored now. */
    retry: (present: number) => {
      version.current = present;
      setConflict(false);
      change.reset();
      void flush();
    },
    busy: change.isPending,
    error: change.error,
  };
}

export type Edits = ReturnType<typeof useEdits>;
