import { Progress, Stack, Table, Text } from '@mantine/core';
import type { Build } from '@/shared/api';
import { formatDuration } from '@/shared/lib/format';
import { useNow } from '@/shared/lib/useNow';
import { Age, Loading, Pager, ProblemAlert, RouteLink, ScrollTable, UserText } from '@/shared/ui';
import { BuildSource } from './BuildSource';
import { BuildStatus } from './BuildStatus';
import classes from './builds.module.css';
import { BUILDS_PER_PAGE, useBuilds, type BuildFilter } from './queries';
import { isFinished, progressOf } from './state';

interface BuildListProps {
  page: number;
  /** Without it, there is no pager. */
  onPage?: (page: number) => void;
  size?: number;
  /** Without it, all builds are listed. */
  filter?: BuildFilter;
}

export function BuildList({ page, onPage, size = BUILDS_PER_PAGE, filter = {} }: BuildListProps) {
  const builds = useBuilds(page, filter, size);
  if (builds.isPending) return <Loading what="builds" />;
  if (!builds.data) {
    return <ProblemAlert title="The builds could not be read" error={builds.error} />;
  }
  const { items, total } = builds.data;
  if (total === 0 && (filter.search || filter.state)) {
    return <Text c="dimmed">No build matches.</Text>;
  }
  if (total === 0)
    return (
      <Text c="dimmed">
        No builds yet. Open an{' '}
        <RouteLink to="/activities" underline="always">
          activity
        </RouteLink>{' '}
        to start one.
      </Text>
    );
  return (
    <Stack gap="xs">
      <ScrollTable label="Builds" minWidth={720}>
        <Table.Thead>
          <Table.Tr>
            <Table.Th>Build</Table.Th>
            <Table.Th>State</Table.Th>
            <Table.Th>Cases</Table.Th>
            <Table.Th>Requested</Table.Th>
            <Table.Th>Duration</Table.Th>
            <Table.Th>Agent</Table.Th>
          </Table.Tr>
        </Table.Thead>
        <Table.Tbody>
          {items.map((build) => (
            <BuildRow key={build.id} build={build} />
          ))}
        </Table.Tbody>
      </ScrollTable>
      {onPage && (
        <Pager label="Pages of builds" page={page} size={size} total={total} onPage={onPage} />
      )}
    </Stack>
  );
}

function BuildRow({ build }: { build: Build }) {
  return (
    <Table.Tr>
      <Table.Td>
        <RouteLink to="/builds/$buildId" params={{ buildId: build.id }} fw={600} size="sm">
          <UserText>{`${build.activityName} / ${build.model}`}</UserText>
        </RouteLink>
        <BuildSource build={build} />
      </Table.Td>
      <Table.Td>
        <BuildStatus build={build} />
        {build.waitingFor && (
          <Text size="xs" c="dimmed">
            <UserText>{build.waitingFor}</UserText>
          </Text>
        )}
      </Table.Td>
      <Table.Td>
        <Cases build={build} />
      </Table.Td>
      <Table.Td>
        <Age at={build.created} />
      </Table.Td>
      <Table.Td className={classes.duration}>
        <Duration build={build} />
      </Table.Td>
      <Table.Td>{build.agent ? <UserText>{build.agent}</UserText> : '–'}</Table.Td>
    </Table.Tr>
  );
}

function Cases({ build }: { build: Build }) {
  const { summary } = build;
  if (summary) {
    const parts = [
      `${summary.pass} of ${summary.total} passed`,
      summary.fail > 0 && `${summary.fail} failed`,
      summary.error > 0 && `${summary.error} with errors`,
      summary.dont > 0 && `${summary.dont} not executed`,
    ];
    return <>{parts.filter(Boolean).join(', ')}</>;
  }
  if (isFinished(build)) return <>–</>;
  return (
    <Stack gap={4}>
      <Text size="sm">
        {build.casesDone} of {build.casesTotal}
      </Text>
      <Progress size="sm" value={progressOf(build)} aria-label="Executed cases" />
    </Stack>
  );
}

function Duration({ build: { started, finished } }: { build: Build }) {
  const now = useNow(1_000);
  if (!started) return <>–</>;
  return <>{formatDuration(started, finished ?? now.toISOString())}</>;
}
