import { SimpleGrid, Stack, Table, Text } from '@mantine/core';
import type { Schedule } from '@/shared/api';
import { labelOfState } from '@/shared/lib/buildStates';
import { formatInstant } from '@/shared/lib/format';
import { labelOfRecordings } from '@/shared/lib/recordings';
import {
  Loading,
  Pager,
  ProblemAlert,
  RouteLink,
  ScrollTable,
  Section,
  UserText,
} from '@/shared/ui';
import { NextTimes } from './NextTimes';
import {
  FIRE_TIMES_PER_PAGE,
  useFireTimes,
  useScheduleAction,
  useScheduleHistory,
} from './queries';
import { ScheduleActions } from './ScheduleActions';
import { MISFIRES, stateOf, timesOf } from './words';

interface ScheduleDetailsProps {
  schedule: Schedule;
  page: number;
  onPage: (page: number) => void;
  onDeleted: () => void;
}

/** The times of a schedule, the options of its builds, and its history. */
export function ScheduleDetails({ schedule, page, onPage, onDeleted }: ScheduleDetailsProps) {
  const times = useFireTimes(schedule.id);
  const act = useScheduleAction();
  return (
    <Stack gap="xl">
      {act.isError && (
        <ProblemAlert title="The schedule was not changed" error={act.error} onClose={act.reset} />
      )}
      <SimpleGrid cols={{ base: 1, md: 2 }} spacing="xl">
        <Section
          title={stateOf(schedule)}
          actions={
            <ScheduleActions schedule={schedule} act={act} size="xs" onDeleted={onDeleted} />
          }
        >
          <Facts schedule={schedule} />
        </Section>
        <Section title="Next times">
          {schedule.paused ? (
            <Text c="dimmed">The schedule is paused.</Text>
          ) : times.data ? (
            <NextTimes times={times.data} zone={schedule.zone} />
          ) : times.isError ? (
            <ProblemAlert title="The times could not be read" error={times.error} />
          ) : (
            <Loading what="the next times" />
          )}
        </Section>
      </SimpleGrid>
      <Section title="History">
        <ScheduleHistory id={schedule.id} page={page} onPage={onPage} />
      </Section>
    </Stack>
  );
}

function Facts({ schedule }: { schedule: Schedule }) {
  const facts: [string, string][] = [
    ['Times', timesOf(schedule)],
    ['Missed times', MISFIRES.find(({ value }) => value === schedule.misfire)?.label ?? ''],
    ['Excluded days', schedule.leaveOut.join(', ') || 'none'],
    [
      'Agent',
      [
        schedule.toolchain && `toolchain ${schedule.toolchain}`,
        schedule.labels.length > 0 && `labels ${schedule.labels.join(', ')}`,
      ]
        .filter(Boolean)
        .join(', ') || 'any agent with the required toolchain',
    ],
    ['Priority', String(schedule.priority)],
    ['Shards', String(schedule.shards)],
    ['Recordings', labelOfRecordings(schedule.recordings ?? '')],
  ];
  if (schedule.ros === 'SYSTEM') {
    facts.push(['ROS 2 nodes', 'run with the ROS 2 of the agent']);
  }
  return (
    <Table verticalSpacing={4} withRowBorders={false} aria-label="Details">
      <Table.Tbody>
        {facts.map(([name, value]) => (
          <Table.Tr key={name}>
            <Table.Th w={130} fw={400} c="dimmed">
              {name}
            </Table.Th>
            <Table.Td>
              <UserText>{value}</UserText>
            </Table.Td>
          </Table.Tr>
        ))}
      </Table.Tbody>
    </Table>
  );
}

function ScheduleHistory({
  id,
  page,
  onPage,
}: {
  id: string;
  page: number;
  onPage: (page: number) => void;
}) {
  const history = useScheduleHistory(id, page);
  if (history.isPending) return <Loading what="the history" />;
  if (!history.data) {
    return <ProblemAlert title="The history could not be read" error={history.error} />;
  }
  if (history.data.total === 0) return <Text c="dimmed">The schedule has not run yet.</Text>;
  return (
    <Stack gap="xs">
      <ScrollTable label="History" minWidth={480}>
        <Table.Thead>
          <Table.Tr>
            <Table.Th>Time</Table.Th>
            <Table.Th>Result</Table.Th>
          </Table.Tr>
        </Table.Thead>
        <Table.Tbody>
          {history.data.items.map((fire) => (
            <Table.Tr key={fire.fireTime}>
              <Table.Td>{formatInstant(fire.fireTime)}</Table.Td>
              <Table.Td>
                {fire.buildId && fire.buildState ? (
                  <RouteLink to="/builds/$buildId" params={{ buildId: fire.buildId }} size="sm">
                    {`Build: ${labelOfState(fire.buildState).toLowerCase()}`}
                  </RouteLink>
                ) : (
                  <UserText>{fire.message ?? 'The build was deleted.'}</UserText>
                )}
              </Table.Td>
            </Table.Tr>
          ))}
        </Table.Tbody>
      </ScrollTable>
      <Pager
        label="Pages of the history"
        page={page}
        size={FIRE_TIMES_PER_PAGE}
        total={history.data.total}
        onPage={onPage}
      />
    </Stack>
  );
}
