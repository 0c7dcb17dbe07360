import { Button, Group, Stack, Text } from '@mantine/core';
import type { Build, RecordedCases } from '@/shared/api';
import { ProblemAlert } from '@/shared/ui';
import { useRequestRecordedBuild } from './queries';

const WHY: Record<RecordedCases, string> = {
  ALL: 'Each case of this build was to be recorded; of this one nothing came. A case whose process was ended leaves no recording, and neither does one beyond the bounds; the log of the build says so.',
  FAILED: 'Only cases that ended as fail or error were recorded in this build.',
  NONE: 'Nothing was recorded in this build.',
};

interface NotRecordedProps {
  build: Build;
  onRequested: (build: Build) => void;
}

/** Why there is nothing to see, and what to do about it. */
export function NotRecorded({ build, onRequested }: NotRecordedProps) {
  const request = useRequestRecordedBuild(build.suiteId);
  const ask = (cases: RecordedCases) => () => {
    request.mutate(cases, { onSuccess: onRequested });
  };
  return (
    <Stack gap="sm" align="start">
      <Text>{WHY[build.recordedCases]}</Text>
      <Group gap="sm">
        <Button size="xs" loading={request.isPending} onClick={ask('ALL')}>
          Build again and record all cases
        </Button>
        <Button size="xs" variant="default" disabled={request.isPending} onClick={ask('FAILED')}>
          Record only those that fail
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
