import { Anchor, Stack } from '@mantine/core';
import type { ReactNode } from 'react';
import type { Build, Verdict } from '@/shared/api';
import { Loading, ProblemAlert } from '@/shared/ui';
import { NotRecorded } from './NotRecorded';
import { Player } from './Player';
import { useRecording } from './queries';

interface CaseReplayProps {
  build: Build;
  caseNo: number;
  verdict?: Verdict | undefined;
  /** The result of the case. */
  facts: ReactNode;
  onRequested: (build: Build) => void;
}

/** The 3D replay of a case. */
export function CaseReplay({ build, caseNo, verdict, facts, onRequested }: CaseReplayProps) {
  const recording = useRecording(build.id, caseNo);
  if (recording.isPending) return <Loading what="the recording" />;
  if (recording.error) {
    return <ProblemAlert title="The recording could not be read" error={recording.error} />;
  }
  if (!recording.data) {
    return (
      <Stack gap="lg">
        <NotRecorded build={build} onRequested={onRequested} />
        {facts}
      </Stack>
    );
  }
  return (
    <Stack gap="sm">
      <Player
        recording={recording.data}
        verdict={verdict}
        label={`3D replay of case ${caseNo}`}
        facts={facts}
      />
      <Anchor
        size="sm"
        href={`/api/v1/builds/${encodeURIComponent(build.id)}/recordings/${caseNo}`}
        download={`case-${caseNo}.glb`}
      >
        Download as glTF
      </Anchor>
    </Stack>
  );
}
