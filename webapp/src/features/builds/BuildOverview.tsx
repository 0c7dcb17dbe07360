import { Alert, Button, Group, Progress, Stack, Text } from '@mantine/core';
import type { Build } from '@/shared/api';
import { formatDuration, formatInstant, formatLeft } from '@/shared/lib/format';
import { useNow } from '@/shared/lib/useNow';
import { Diagnostics, ProblemAlert, UserText } from '@/shared/ui';
import { BuildSource } from './BuildSource';
import { BuildStatus } from './BuildStatus';
import { useCancelBuild } from './queries';
import { isFinished, progressOf, secondsLeft } from './state';

/** The status of a build with its times and its agent, its progress, and the reason of a failure. */
export function BuildOverview({ build }: { build: Build }) {
  return (
    <Stack gap="sm">
      <Group gap="lg">
        <span role="status">
          <BuildStatus build={build} />
        </span>
        <Facts build={build} />
      </Group>
      <BuildSource build={build} />
      {build.waitingFor && (
        <Text>
          Waiting: <UserText>{build.waitingFor}</UserText>
        </Text>
      )}
      {!isFinished(build) && (build.requirements.length > 0 || build.priority !== 0) && (
        <Text size="sm" c="dimmed">
          Requires an agent with <UserText>{build.requirements.join(', ')}</UserText>
          {build.priority !== 0 && `; priority ${build.priority}`}
        </Text>
      )}
      {!isFinished(build) && <Running build={build} />}
      {build.failure && (
        <Alert
          role="alert"
          color="red"
          variant="outline"
          title={`Could not run: ${build.failure.category.toLowerCase().replaceAll('_', ' ')}`}
        >
          <Stack gap="xs">
            <Text size="sm">
              <UserText>{build.failure.message}</UserText>
            </Text>
            {build.failure.diagnostics.length > 0 && (
              <Diagnostics items={build.failure.diagnostics} />
            )}
          </Stack>
        </Alert>
      )}
    </Stack>
  );
}

function Facts({ build }: { build: Build }) {
  const now = useNow(1_000);
  return (
    <Text size="sm" c="dimmed">
      {build.cases !== undefined &&
        `Only case${/[,-]/.test(build.cases) ? 's' : ''} ${shortened(build.cases)}. `}
      Requested {formatInstant(build.created)}
      {build.started &&
        `, ${build.finished ? 'duration' : 'running for'} ${formatDuration(build.started, build.finished ?? now.toISOString())}`}
      {build.agent && (
        <>
          {', on agent '}
          <UserText>{build.agent}</UserText>
        </>
      )}
      {build.attempt > 1 && `, attempt ${build.attempt}`}
    </Text>
  );
}

/** A long list of numbers ends after the first of them. */
function shortened(cases: string): string {
  const shown = 80;
  return cases.length <= shown
    ? cases.replaceAll(',', ', ')
    : `${cases.slice(0, cases.lastIndexOf(',', shown)).replaceAll(',', ', ')}, …`;
}

function Running({ build }: { build: Build }) {
  const cancel = useCancelBuild(build.id);
  const left = secondsLeft(build, useNow(1_000));
  return (
    <>
      <Group gap="md">
        <Progress flex={1} value={progressOf(build)} aria-label="Executed cases" />
        <Text size="sm">
          {build.casesDone} of {build.casesTotal} cases
          {left !== null && `, ${formatLeft(left)}`}
        </Text>
        <Button
          variant="default"
          size="xs"
          loading={cancel.isPending}
          onClick={() => {
            cancel.mutate();
          }}
        >
          Cancel
        </Button>
      </Group>
      {cancel.isError && (
        <ProblemAlert
          title="The build was not cancelled"
          error={cancel.error}
          onClose={cancel.reset}
        />
      )}
    </>
  );
}
