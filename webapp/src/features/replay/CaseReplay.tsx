import { Anchor, Stack } from '@mantine/core';
import type { ReactNode } from 'react';
import type { Build, Verdict } from '@/shared/api';
import { Loading, ProblemAlert } from '@/shared/ui';
import type { EventMark } from './EventMarks';
import { NotRecorded } from './NotRecorded';
import { Player } from './Player';
import type { StepMark } from './StepMarks';
import { useRecording } from './queries';
import type { Recording } from './recording';
import type { Playback } from './usePlayback';

interface CaseReplayProps {
  build: Build;
  caseNo: number;
  verdict?: Verdict | undefined;
  /** The result of the case. */
  facts: ReactNode;
  onRequested: (build: Build) => void;
  /** The time of the recording to show first. */
  startAt?: ((recording: Recording) => number | undefined) | undefined;
  /** More about the case over time. Recording and playback are null if there is no recording. */
  plot?: ((recording: Recording | null, playback: Playback | null) => ReactNode) | undefined;
  /** The steps of a sequence. */
  marks?: ((recording: Recording) => readonly StepMark[]) | undefined;
  /** Faults of devices, and what conditions over time say. */
  events?: ((recording: Recording) => readonly EventMark[]) | undefined;
  /** Whether `startAt` and `plot` are not known yet. */
  loading?: boolean;
}

/** The 3D replay of a case. */
export function CaseReplay({
  build,
  caseNo,
  verdict,
  facts,
  onRequested,
  startAt,
  plot,
  marks,
  events,
  loading = false,
}: CaseReplayProps) {
  const { data, error, isPending } = useRecording(build.id, caseNo);
  if (isPending || loading) return <Loading what="the recording" />;
  if (error) {
    return <ProblemAlert title="The recording could not be read" error={error} />;
  }
  if (!data) {
    return (
      <Stack gap="lg">
        <NotRecorded build={build} onRequested={onRequested} />
        {plot?.(null, null)}
        {facts}
      </Stack>
    );
  }
  return (
    <Stack gap="sm">
      <Player
        recording={data}
        verdict={verdict}
        label={`3D replay of case ${caseNo}`}
        facts={facts}
        startAt={startAt?.(data)}
        marks={marks?.(data)}
        events={events?.(data)}
        plot={plot && ((playback) => plot(data, playback))}
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
