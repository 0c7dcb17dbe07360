import { Button, Group, Stack, Switch, Text } from '@mantine/core';
import { useMutation } from '@tanstack/react-query';
import { useEffect, useRef, useState } from 'react';
import { useApi } from '@/shared/api';
import { visible } from '@/shared/lib/visible';
import { ProblemAlert } from '@/shared/ui';
import classes from './builds.module.css';
import { readLog, wholeLog } from './wholeLog';

const POLL_MS = 1_000;
/** The page shows the end of a log, at most this many characters; the download is complete. */
const MAX_SHOWN = 400_000;

/** The log of a build, followed while it grows, shown as plain text. */
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
          label="Follow the log"
          checked={follow}
          onChange={(event) => {
            setFollow(event.currentTarget.checked);
          }}
        />
        <DownloadButton buildId={buildId} />
      </Group>
      {error && <ProblemAlert title="The log could not be read" error={error} />}
      {cut && (
        <Text size="sm" c="dimmed">
          Only the end of the log is shown.
        </Text>
      )}
      {/* Focusable, so that it can be scrolled by keyboard. */}
      <pre ref={place} className={classes.log} tabIndex={0} role="log" aria-label="Log">
        {text === '' ? 'The log is empty.' : visible(text)}
      </pre>
    </Stack>
  );
}

function DownloadButton({ buildId }: { buildId: string }) {
  const api = useApi();
  const download = useMutation({
    mutationFn: () => wholeLog(api, buildId),
    onSuccess: (log) => {
      saveAs(log, `build-${buildId}.log`);
    },
  });
  return (
    <>
      <Button
        size="xs"
        variant="default"
        loading={download.isPending}
        onClick={() => {
          download.mutate();
        }}
      >
        Download
      </Button>
      {download.isError && (
        <ProblemAlert
          title="The log could not be downloaded"
          error={download.error}
          onClose={download.reset}
        />
      )}
    </>
  );
}

function saveAs(content: Blob, name: string) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  URL.revokeObjectURL(link.href);
}

interface Log {
  text: string;
  cut: boolean;
  error: Error | null;
}

/** Reads the log from the last offset on, until the build has ended and the log is complete. */
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
        const { bytes, end } = await readLog(api, buildId, offset.current, gone.signal);
        if (gone.signal.aborted) return;
        offset.current += bytes.byteLength;
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
