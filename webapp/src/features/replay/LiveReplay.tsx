import { Stack, Text } from '@mantine/core';
import { useState, type ReactNode } from 'react';
import type { Build } from '@/shared/api';
import { plural } from '@/shared/lib/format';
import { Loading, ProblemAlert } from '@/shared/ui';
import { Player } from './Player';
import { useNewestRecording, useRecording } from './queries';

interface Shown {
  caseNo: number;
  sha256: string;
}

interface LiveReplayProps {
  build: Build;
  running: boolean;
  /** A link to the page of a case. */
  caseLink: (caseNo: number) => ReactNode;
}

/**
 * The newest case of a build of which there is a recording. One is played to its end, then comes the one that is the newest
 * by then: cases that end faster than they can be watched are passed over.
 */
export function LiveReplay({ build, running, caseLink }: LiveReplayProps) {
  const found = useNewestRecording(build.id, running);
  const [shown, setShown] = useState<Shown | null>(null);
  const [seen, setSeen] = useState<Shown | null>(null);
  const newest = found.data?.newest ?? null;
  // Before the first, both are null.
  const free = seen === shown;
  const isNew = newest?.caseNo !== shown?.caseNo || newest?.sha256 !== shown?.sha256;
  if (newest && free && isNew) setShown({ caseNo: newest.caseNo, sha256: newest.sha256 });
  if (found.isPending) return <Loading what="recordings" />;
  if (found.error && !found.data) {
    return <ProblemAlert title="Recordings could not be read" error={found.error} />;
  }
  if (!shown) {
    return (
      <Text c="dimmed" role="status">
        {waiting(build, running)}
      </Text>
    );
  }
  return (
    <Stack gap="sm">
      <Text role="status">
        Case {caseLink(shown.caseNo)}; {plural(found.data?.total ?? 0, 'case')} recorded so far
        {running ? '' : ', and the build has ended'}.
      </Text>
      <Film
        build={build}
        shown={shown}
        onEnd={() => {
          setSeen(shown);
        }}
      />
    </Stack>
  );
}

function waiting({ recordedCases }: Build, running: boolean): string {
  if (recordedCases === 'NONE') return 'Nothing is recorded in this build.';
  if (!running) return 'The build has ended, and nothing was recorded.';
  return recordedCases === 'ALL'
    ? 'The first case that ends is shown here.'
    : 'The first case that ends as fail or error is shown here; others are not recorded in this build.';
}

function Film({ build, shown, onEnd }: { build: Build; shown: Shown; onEnd: () => void }) {
  const recording = useRecording(build.id, shown.caseNo, shown.sha256);
  if (recording.error) {
    return <ProblemAlert title="The recording could not be read" error={recording.error} />;
  }
  if (!recording.data) return <Loading what="the recording" />;
  return (
    <Player
      recording={recording.data}
      label={`What moved in case ${shown.caseNo}`}
      onEnd={recording.isPlaceholderData ? undefined : onEnd}
    />
  );
}
