import { useEffect, useRef, useState } from 'react';
import type { Suite } from '@/shared/api';
import { ApiError } from '@/shared/api';
import { useChangeSuite, type ExpectedChange, type SuiteChange } from './queries';

/** Identifies an expected value. */
export function cellKey(no: number, output: string): string {
  return `${no} ${output}`;
}

/**
 * Sends the changes of a suite one after another, each with the version that the previous change
 * returned. Changes made in the meantime are sent together. A conflict stops sending, so that
 * nothing is overwritten.
 */
export function useEdits(suite: Suite) {
  const change = useChangeSuite(suite.id);
  /** Unsaved values by cell; they are shown instead of the stored values. */
  const [drafts, setDrafts] = useState<ReadonlyMap<string, string>>(new Map());
  const pending = useRef<Map<string, ExpectedChange>>(new Map());
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
    while (pending.current.size > 0) {
      const batch = pending.current;
      pending.current = new Map();
      const sent = await send({ kind: 'expected', changes: [...batch.values()] });
      if (!sent) {
        // Kept for another attempt; newer values of the same cell have precedence.
        pending.current = new Map([...batch, ...pending.current]);
        return;
      }
      setDrafts((old) => new Map([...old].filter(([key]) => pending.current.has(key))));
    }
  }

  function set(changes: readonly ExpectedChange[]) {
    for (const item of changes) {
      pending.current.set(cellKey(item.no, item.output ?? ''), item);
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
    pending.current = new Map();
    setDrafts(new Map());
    setConflict(false);
    change.reset();
  }

  return {
    drafts,
    set,
    /** Applies any other change, after the unsaved values were sent. */
    apply: async (next: SuiteChange) => {
      await flush();
      return pending.current.size === 0 && (await send(next));
    },
    conflict,
    discard,
    /** Sends the unsaved values again, based on the current version. */
    retry: (currentVersion: number) => {
      version.current = currentVersion;
      setConflict(false);
      change.reset();
      void flush();
    },
    busy: change.isPending,
    error: change.error,
  };
}

export type Edits = ReturnType<typeof useEdits>;
