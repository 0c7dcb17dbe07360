import { Button, Group, Stack, Switch, Text } from '@mantine/core';
import { useEffect, useRef, useState } from 'react';
import { useApi } from '@/shared/api';
import { visible } from '@/shared/lib/visible';
import { ProblemAlert } from '@/shared/ui';
import classes from './builds.module.css';

const POLL_MS = 1_000;
/** What the page keeps: the end of a log; all of it can be downloaded. */
const MAX_SHOWN = 400_000;

/** The log of a build, followed while it grows. Whatever stands in it is text. */
export function BuildLog({ buildId, live }: { buildId: string; live: boolean }) {
  const { text, cut, error } = useLog(buildId, live);
  const [follow, setFollow] = useState(true);
  const place = useRef<HTMLPreElement>(null);
  useEffect(() => {
    if (follow && place.current) place.current.scrollTop = place.current.scrollHeight;
  }, [text, follow]);
  return (
    <Stack gap="xs">
      <Group justify="space-between">
        <Switch
          label="Follow the end"
          checked={follow}
          onChange={(event) => {
            setFollow(event.currentTarget.checked);
          }}
        />
        <Button
          component="a"
          size="xs"
          variant="default"
          href={`/api/v1/builds/${encodeURIComponent(buildId)}/log`}
          download={`build-${buildId}.log`}
        >
          Download
        </Button>
      </Group>
      {error && <ProblemAlert title="The log could not be read" error={error} />}
      {cut && (
        <Text size="sm" c="dimmed">
          Only the end is shown.
        </Text>
      )}
      {/* A log is long: the keyboard must reach it to scroll. */}
      <pre ref={place} className={classes.log} tabIndex={0} role="log" aria-label="Log">
        {text === '' ? 'The log is empty.' : visible(text)}
      </pre>
    </Stack>
  );
}

interface Log {
  text: string;
  cut: boolean;
  error: Error | null;
}

/** Reads on from where it stopped, until the build has ended and the log with it. */
function useLog(buildId: string, live: boolean): Log {
  const api = useApi();
  const [log, setLog] = useState<Log>({ text: '', cut: false, error: null });
  const offset = useRef(0);
  const partial = useRef(new TextDecoder());
  useEffect(() => {
    const gone = new AbortController();
    let timer: ReturnType<typeof setTimeout> | undefined;
    const read = async () => {
      let more = live;
      try {
        const { data, response } = await api.GET('/api/v1/builds/{id}/log', {
          params: { path: { id: buildId }, query: { offset: offset.current } },
          parseAs: 'arrayBuffer',
          signal: gone.signal,
        });
        if (gone.signal.aborted) return;
        if (!response.ok || !data) throw new Error(`The server answered ${response.status}.`);
        const bytes = data;
        offset.current += bytes.byteLength;
        const end = Number(response.headers.get('Sitaf-Log-End') ?? offset.current);
        const added = partial.current.decode(bytes, { stream: true });
        setLog((old) => append(old, added));
        more = live || (bytes.byteLength > 0 && offset.current < end);
        timer = setTimeout(() => void read(), offset.current < end ? 0 : POLL_MS);
      } catch (cause) {
        if (gone.signal.aborted) return;
        setLog((old) => ({
          ...old,
          error: cause instanceof Error ? cause : new Error(String(cause)),
        }));
        timer = setTimeout(() => void read(), POLL_MS);
      }
      if (!more) clearTimeout(timer);
    };
    void read();
    return () => {
      gone.abort();
      clearTimeout(timer);
    };
  }, [api, buildId, live]);
  return log;
}

function append(old: Log, added: string): Log {
  if (added === '' && !old.error) return old;
  const text = old.text + added;
  return text.length > MAX_SHOWN
    ? { text: text.slice(-MAX_SHOWN), cut: true, error: null }
    : { text, cut: old.cut, error: null };
}
