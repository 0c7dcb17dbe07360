import { Button, Group, Stack, Text } from '@mantine/core';
import type { Build, RecordedCases } from '@/shared/api';
import { ProblemAlert } from '@/shared/ui';
import { useRequestRecordedBuild } from './queries';

const REASONS: Record<RecordedCases, string> = {
  ALL: 'There is no recording of this case. The process of the case was stopped, or the recording was too large; see the log of the build.',
  FAILED: 'Only cases that failed or ended with an error were recorded in this build.',
  NONE: 'Recording was switched off in this build.',
};

interface NotRecordedProps {
  build: Build;
  onRequested: (build: Build) => void;
}

/** The reason why a case has no recording, and actions to record it. */
export function NotRecorded({ build, onRequested }: NotRecordedProps) {
  const request = useRequestRecordedBuild(build);
  const rebuild = (cases: RecordedCases) => () => {
    request.mutate(cases, { onSuccess: onRequested });
  };
  return (
    <Stack gap="sm" align="start">
      <Text>{REASONS[build.recordedCases]}</Text>
      <Group gap="sm">
        <Button size="xs" loading={request.isPending} onClick={rebuild('ALL')}>
          Build again, record all cases
        </Button>
        <Button
          size="xs"
          variant="default"
          disabled={request.isPending}
          onClick={rebuild('FAILED')}
        >
          Build again, record failing cases
        </Button>
      </Group>
      {request.isError && (
        <ProblemAlert
          title="The build was not requested"
          error={request.error}
          onClose={request.reset}
        />
      )}
    </Stack>
  );
}
