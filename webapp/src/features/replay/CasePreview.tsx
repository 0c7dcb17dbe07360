import { Button, Text } from '@mantine/core';
import { useState } from 'react';
import type { Build, Verdict } from '@/shared/api';
import { ProblemAlert } from '@/shared/ui';
import { useRecordedCases, useRecording } from './queries';
import classes from './replay.module.css';
import { StageView } from './StageView';
import { usePlayback } from './usePlayback';
import type { Recording } from './recording';

interface CasePreviewProps {
  build: Build;
  no: number;
  verdict?: Verdict | undefined;
}

/** A small replay of a case, which is loaded when it is wanted. Nothing if the case has no recording. */
export function CasePreview({ build, no, verdict }: CasePreviewProps) {
  const [wanted, setWanted] = useState(false);
  const recorded = useRecordedCases(build.id);
  const exists = recorded.data?.items.some(({ caseNo }) => caseNo === no);
  if (!exists) {
    return recorded.data ? (
      <Text size="sm" c="dimmed">
        This case has no recording.
      </Text>
    ) : null;
  }
  return (
    <div className={classes.preview}>
      {wanted ? (
        <Loaded build={build} no={no} verdict={verdict} />
      ) : (
        <Button
          variant="default"
          size="sm"
          className={classes.poster ?? ''}
          onClick={() => {
            setWanted(true);
          }}
        >
          ▶ Replay case {no} in 3D
        </Button>
      )}
    </div>
  );
}

function Loaded({ build, no, verdict }: CasePreviewProps) {
  const recording = useRecording(build.id, no);
  if (recording.error) {
    return <ProblemAlert title="The recording could not be read" error={recording.error} />;
  }
  return recording.data && <Playing recording={recording.data} no={no} verdict={verdict} />;
}

function Playing({
  recording,
  no,
  verdict,
}: {
  recording: Recording;
  no: number;
  verdict: Verdict | undefined;
}) {
  const playback = usePlayback(recording.times, true);
  return (
    <>
      <StageView
        recording={recording}
        verdict={verdict}
        time={playback.time}
        following={false}
        label={`3D replay of case ${no}`}
        onReady={() => undefined}
      />
      <Button
        variant="default"
        size="compact-xs"
        className={classes.again ?? ''}
        onClick={playback.toggle}
      >
        {playback.running ? 'Pause' : 'Play'}
      </Button>
    </>
  );
}
