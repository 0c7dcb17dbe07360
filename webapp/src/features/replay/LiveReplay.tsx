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
 * Plays the newest recorded case of a build to its end, then the case that is the newest by then.
 * Cases that end faster than they can be played are skipped.
 */
export function LiveReplay({ build, running, caseLink }: LiveReplayProps) {
  const found = useNewestRecording(build.id, running);
  const [shown, setShown] = useState<Shown | null>(null);
  const [played, setPlayed] = useState<Shown | null>(null);
  const newest = found.data?.newest ?? null;
  // Both are null before the first recording.
  const idle = played === shown;
  const isNew = newest?.caseNo !== shown?.caseNo || newest?.sha256 !== shown?.sha256;
  if (newest && idle && isNew) setShown({ caseNo: newest.caseNo, sha256: newest.sha256 });
  if (found.isPending) return <Loading what="recordings" />;
  if (found.error && !found.data) {
    return <ProblemAlert title="The recordings could not be read" error={found.error} />;
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
        Case {caseLink(shown.caseNo)}; {plural(found.data?.total ?? 0, 'recorded case')}.
        {!running && ' The build has ended.'}
      </Text>
      <Replay
        build={build}
        shown={shown}
        onEnd={() => {
          setPlayed(shown);
        }}
      />
    </Stack>
  );
}

function waiting({ recordedCases }: Build, running: boolean): string {
  if (recordedCases === 'NONE') return 'This build has no recordings.';
  if (!running) return 'The build has ended without recordings.';
  return recordedCases === 'ALL'
    ? 'Waiting for the first case to end.'
    : 'Waiting for the first case that fails or ends with an error; other cases are not recorded.';
}

function Replay({ build, shown, onEnd }: { build: Build; shown: Shown; onEnd: () => void }) {
  const recording = useRecording(build.id, shown.caseNo, { sha256: shown.sha256 });
  if (recording.error) {
    return <ProblemAlert title="The recording could not be read" error={recording.error} />;
  }
  if (!recording.data) return <Loading what="the recording" />;
  return (
    <Player
      recording={recording.data}
      label={`3D replay of case ${shown.caseNo}`}
      onEnd={recording.isPlaceholderData ? undefined : onEnd}
    />
  );
}
