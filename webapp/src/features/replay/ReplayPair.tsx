import { Button, Group, SimpleGrid, Slider, Stack, Table, Text } from '@mantine/core';
import { useMemo, useState } from 'react';
import { Loading, ProblemAlert, ScrollTable, Section, UserText } from '@/shared/ui';
import { divergenceOf, type Divergence } from './divergence';
import { useRecording } from './queries';
import { frameAt, readingsIn, type Recording } from './recording';
import { StageView } from './StageView';
import { usePlayback, type Playback } from './usePlayback';

/** A recorded run of a case of a build. */
interface RecordedCase {
  buildId: string;
  caseNo: number;
  /** The place of a relation in the model, from 1, for the second run of the case. */
  relation?: number;
  label: string;
}

interface ReplayPairProps {
  base: RecordedCase;
  now: RecordedCase;
  /** The begin of the first divergent step in the recording of `now`, in simulation time. */
  divergesAt?: ((recording: Recording) => number | undefined) | undefined;
}

/** The replays of a case in two builds, or of its two runs for a relation, side by side in step, stopped where they diverge. */
export function ReplayPair({ base, now, divergesAt }: ReplayPairProps) {
  const left = useRecording(base.buildId, base.caseNo, base);
  const right = useRecording(now.buildId, now.caseNo, now);
  const error = left.error ?? right.error;
  if (error) return <ProblemAlert title="The recordings could not be read" error={error} />;
  if (left.isPending || right.isPending) return <Loading what="the recordings" />;
  if (!left.data || !right.data) {
    const missing = [left.data ? null : base.label, right.data ? null : now.label];
    return (
      <Text c="dimmed" role="status">
        Not recorded in {missing.filter(Boolean).join(' and ')}. Build again with recordings to see
        both replays.
      </Text>
    );
  }
  return (
    <Pair
      key={[base, now].map((of) => `${of.buildId} ${of.caseNo} ${of.relation ?? ''}`).join(' ')}
      base={{ ...base, recording: left.data }}
      now={{ ...now, recording: right.data }}
      divergesAt={divergesAt?.(right.data)}
    />
  );
}

interface Shown extends RecordedCase {
  recording: Recording;
}

function Pair({
  base,
  now,
  divergesAt,
}: {
  base: Shown;
  now: Shown;
  divergesAt: number | undefined;
}) {
  const times = useMemo(() => commonTimes(base.recording, now.recording), [base, now]);
  const found = useMemo(() => divergenceOf(base.recording, now.recording), [base, now]);
  const divergence: Divergence | undefined = useMemo(() => {
    if (divergesAt === undefined) return found;
    const seconds = divergesAt - (now.recording.times[0] ?? 0);
    return { frame: frameAt(now.recording, divergesAt), seconds, what: found?.what ?? '' };
  }, [divergesAt, found, now]);
  const playback = usePlayback(times, false, divergence?.seconds, divergence?.seconds);
  return (
    <Stack gap="sm" role="group" aria-label="Both replays">
      <Text role="status">
        {divergence
          ? `They diverge at ${divergence.seconds.toFixed(3)} s`
          : 'The recordings do not diverge'}
        {divergence?.what && (
          <>
            {': '}
            <UserText>{divergence.what}</UserText>
          </>
        )}
        .
      </Text>
      <SimpleGrid cols={{ base: 1, md: 2 }}>
        <View of={base} time={playback.time} />
        <View of={now} time={playback.time} />
      </SimpleGrid>
      <Controls playback={playback} times={times} divergence={divergence} />
      <BothReadings base={base} now={now} time={playback.time} />
    </Stack>
  );
}

/** Seconds since the begin, over the longer recording. */
function commonTimes(one: Recording, other: Recording): Float32Array {
  const [longer] = [one.times, other.times].sort((a, b) => lengthOf(b) - lengthOf(a));
  const begin = longer?.[0] ?? 0;
  return (longer ?? new Float32Array()).map((time) => time - begin);
}

function lengthOf(times: Float32Array): number {
  return (times.at(-1) ?? 0) - (times[0] ?? 0);
}

function timeIn({ times }: Recording, seconds: number): number {
  return Math.min(times.at(-1) ?? 0, (times[0] ?? 0) + seconds);
}

function View({ of, time }: { of: Shown; time: number }) {
  const [following, setFollowing] = useState(false);
  return (
    <Section title={of.label}>
      <StageView
        recording={of.recording}
        time={timeIn(of.recording, time)}
        following={following}
        label={`3D replay of case ${of.caseNo}, ${of.label}`}
        onReady={(body) => {
          setFollowing(body !== null);
        }}
      />
    </Section>
  );
}

function Controls({
  playback,
  times,
  divergence,
}: {
  playback: Playback;
  times: Float32Array;
  divergence: Divergence | undefined;
}) {
  const { begin, end, time, running } = playback;
  const still = end <= begin;
  const near = nearest(times, time);
  return (
    <Group gap="sm">
      <Button size="xs" w={80} disabled={still} onClick={playback.toggle}>
        {running ? 'Pause' : 'Play'}
      </Button>
      <Button
        size="xs"
        variant="default"
        disabled={still}
        onClick={() => {
          playback.seek(times[near - 1] ?? begin);
        }}
      >
        Previous step
      </Button>
      <Button
        size="xs"
        variant="default"
        disabled={still}
        onClick={() => {
          playback.seek(times[near + 1] ?? end);
        }}
      >
        Next step
      </Button>
      {divergence && (
        <Button
          size="xs"
          variant="default"
          onClick={() => {
            playback.seek(divergence.seconds);
          }}
        >
          To the divergence
        </Button>
      )}
      <Slider
        flex="1 1 10rem"
        thumbLabel="Time"
        thumbProps={{ 'aria-valuetext': `${time.toFixed(2)} s` }}
        label={null}
        disabled={still}
        min={0}
        max={still ? 1 : end}
        step={0.001}
        value={time}
        onChange={playback.seek}
      />
      <Text size="sm" data-testid="pair-clock">
        {time.toFixed(2)} of {end.toFixed(2)} s
      </Text>
    </Group>
  );
}

/** The last of ascending times at or before a time. */
function nearest(times: Float32Array, time: number): number {
  const after = times.findIndex((each) => each > time + 1e-9);
  return after < 0 ? times.length - 1 : Math.max(0, after - 1);
}

/** The readings of both at a time; those that differ are marked. */
function BothReadings({ base, now, time }: { base: Shown; now: Shown; time: number }) {
  const ofBase = readings(base.recording, time);
  const ofNow = readings(now.recording, time);
  if (ofNow.size === 0) return null;
  return (
    <ScrollTable label="Readings of both" minWidth={480}>
      <Table.Thead>
        <Table.Tr>
          <Table.Th>Reading</Table.Th>
          <Table.Th ta="right">{base.label}</Table.Th>
          <Table.Th ta="right">{now.label}</Table.Th>
        </Table.Tr>
      </Table.Thead>
      <Table.Tbody>
        {[...ofNow].map(([name, value]) => {
          const other = ofBase.get(name) ?? '–';
          const weight = other === value ? undefined : 700;
          return (
            <Table.Tr key={name} data-differs={other !== value}>
              <Table.Th scope="row">
                <UserText>{name}</UserText>
              </Table.Th>
              <Table.Td ta="right" fw={weight}>
                {other}
              </Table.Td>
              <Table.Td ta="right" fw={weight}>
                {value}
              </Table.Td>
            </Table.Tr>
          );
        })}
      </Table.Tbody>
    </ScrollTable>
  );
}

function readings(recording: Recording, time: number): Map<string, string> {
  const values = readingsIn(recording, frameAt(recording, timeIn(recording, time)));
  return new Map(
    recording.columns.map((name, index) => [
      name,
      String(Number((values[index] ?? NaN).toPrecision(6))),
    ]),
  );
}
