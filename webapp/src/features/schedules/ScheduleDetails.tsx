import { SimpleGrid, Stack, Table, Text } from '@mantine/core';
import type { Schedule } from '@/shared/api';
import { buildStateInWords } from '@/shared/lib/buildStates';
import { formatInstant } from '@/shared/lib/format';
import { recordingsInWords } from '@/shared/lib/recordings';
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
import { FIRES_PER_PAGE, useFires, useFireTimes, useScheduleAction } from './queries';
import { ScheduleActions } from './ScheduleActions';
import { MISFIRES, stateOf, timesOf } from './words';

interface ScheduleDetailsProps {
  schedule: Schedule;
  page: number;
  onPage: (page: number) => void;
  onDeleted: () => void;
}

/** When a schedule fires, how it builds, and what came of its times. */
export function ScheduleDetails({ schedule, page, onPage, onDeleted }: ScheduleDetailsProps) {
  const times = useFireTimes(schedule.id);
  const act = useScheduleAction();
  return (
    <Stack gap="xl">
      {act.isError && (
        <ProblemAlert title="The schedule stays as it was" error={act.error} onClose={act.reset} />
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
            <Text c="dimmed">It is paused, and fires when it is resumed.</Text>
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
        <Fires id={schedule.id} page={page} onPage={onPage} />
      </Section>
    </Stack>
  );
}

function Facts({ schedule }: { schedule: Schedule }) {
  const facts: [string, string][] = [
    ['Times', timesOf(schedule)],
    ['Missed times', MISFIRES.find(({ value }) => value === schedule.misfire)?.label ?? ''],
    ['Left out', schedule.leaveOut.join(', ') || 'no days'],
    [
      'Agent',
      [
        schedule.toolchain && `toolchain ${schedule.toolchain}`,
        schedule.labels.length > 0 && `labels ${schedule.labels.join(', ')}`,
      ]
        .filter(Boolean)
        .join(', ') || 'any that offers what the files need',
    ],
    ['Priority', String(schedule.priority)],
    ['Shards', String(schedule.shards)],
    ['Recordings', recordingsInWords(schedule.recordings ?? '')],
  ];
  return (
    <Table verticalSpacing={4} withRowBorders={false} aria-label="Facts">
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

function Fires({ id, page, onPage }: { id: string; page: number; onPage: (page: number) => void }) {
  const fires = useFires(id, page);
  if (fires.isPending) return <Loading what="the history" />;
  if (!fires.data) {
    return <ProblemAlert title="The history could not be read" error={fires.error} />;
  }
  if (fires.data.total === 0) return <Text c="dimmed">It has not fired yet.</Text>;
  return (
    <Stack gap="xs">
      <ScrollTable label="History" minWidth={480}>
        <Table.Thead>
          <Table.Tr>
            <Table.Th>Time</Table.Th>
            <Table.Th>What came of it</Table.Th>
          </Table.Tr>
        </Table.Thead>
        <Table.Tbody>
          {fires.data.items.map((fire) => (
            <Table.Tr key={fire.fireTime}>
              <Table.Td>{formatInstant(fire.fireTime)}</Table.Td>
              <Table.Td>
                {fire.buildId && fire.buildState ? (
                  <RouteLink to="/builds/$buildId" params={{ buildId: fire.buildId }} size="sm">
                    {`Build: ${buildStateInWords(fire.buildState).toLowerCase()}`}
                  </RouteLink>
                ) : (
                  <UserText>{fire.message ?? 'A build that is gone.'}</UserText>
                )}
              </Table.Td>
            </Table.Tr>
          ))}
        </Table.Tbody>
      </ScrollTable>
      <Pager
        label="Pages of the history"
        page={page}
        size={FIRES_PER_PAGE}
        total={fires.data.total}
        onPage={onPage}
      />
    </Stack>
  );
}
