import { Container, Stack, Text, Title } from '@mantine/core';
import { Player } from '@/features/replay';
import { UserText } from '@/shared/ui';
import { useLiveCase, type LiveState } from './useLiveCase';

/** The scene of the case that is debugged, at the simulation time at which it stands. */
export function LiveCase() {
  const state = useLiveCase();
  const { watched, recording, failure } = state;
  return (
    <Container size="lg" py="md">
      <title>{watched ? `Case ${watched.no} · ${watched.model} · SITAF` : 'SITAF'}</title>
      <Stack gap="md">
        <div>
          <Title order={1} size="h3">
            {watched ? `Case ${watched.no}` : 'Case'}
          </Title>
          {watched && (
            <Text c="dimmed">
              <UserText>{`${watched.activity}, ${watched.model}`}</UserText>
            </Text>
          )}
        </div>
        {watched && watched.inputs.length > 0 && (
          <Text size="sm">
            <UserText>
              {watched.inputs
                .map(({ name, literal }) => `${name} = ${literal === '' ? '""' : literal}`)
                .join(', ')}
            </UserText>
          </Text>
        )}
        <Text role="status">{failure ?? statusOf(state)}</Text>
        {recording && watched && (
          <Player
            recording={recording}
            label={`Scene of case ${watched.no}`}
            startAt={recording.times[recording.times.length - 1]}
          />
        )}
      </Stack>
    </Container>
  );
}

function statusOf({ watched, recording, lost }: LiveState): string {
  if (lost) return 'The command has ended. This is the last state of the case.';
  if (!recording) return 'The case has not begun.';
  if (watched?.ended) return 'The case has ended.';
  const { times } = recording;
  const passed = (times[times.length - 1] ?? 0) - (times[0] ?? 0);
  return `The case runs: ${passed.toFixed(3)} s of simulation time. It stands still while the component is halted.`;
}
