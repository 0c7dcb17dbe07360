import { Stack, Table, Text } from '@mantine/core';
import { formatMoment, formatUntil } from '@/shared/lib/format';
import { useNow } from '@/shared/lib/useNow';
import type { Schedule } from '@/shared/api';
import { Loading, Pager, ProblemAlert, RouteLink, ScrollTable, UserText } from '@/shared/ui';
import { SCHEDULES_PER_PAGE, useScheduleAction, useSchedules } from './queries';
import { ScheduleActions } from './ScheduleActions';
import { stateOf, timesOf, titleOf } from './words';

interface ScheduleListProps {
  page: number;
  onPage?: (page: number) => void;
  /** Shows only the names and next times of active schedules. */
  upcoming?: boolean;
}

export function ScheduleList({ page, onPage, upcoming = false }: ScheduleListProps) {
  const schedules = useSchedules(page);
  const act = useScheduleAction();
  if (schedules.isPending) return <Loading what="schedules" />;
  if (!schedules.data) {
    return <ProblemAlert title="The schedules could not be read" error={schedules.error} />;
  }
  const items = schedules.data.items.filter(({ next, paused }) => !upcoming || (next && !paused));
  if (items.length === 0) {
    return <Text c="dimmed">{upcoming ? 'No scheduled builds.' : 'No schedules yet.'}</Text>;
  }
  return (
    <Stack gap="xs">
      {act.isError && (
        <ProblemAlert title="The schedule was not changed" error={act.error} onClose={act.reset} />
      )}
      <ScrollTable label="Schedules" minWidth={upcoming ? 320 : 720}>
        <Table.Thead>
          <Table.Tr>
            <Table.Th>Schedule</Table.Th>
            <Table.Th>Next</Table.Th>
            {!upcoming && (
              <>
                <Table.Th>Times</Table.Th>
                <Table.Th>State</Table.Th>
                <Table.Th aria-label="Actions" />
              </>
            )}
          </Table.Tr>
        </Table.Thead>
        <Table.Tbody>
          {items.map((schedule) => (
            <Table.Tr key={schedule.id}>
              <Table.Td>
                <RouteLink
                  to="/schedules/$scheduleId"
                  params={{ scheduleId: schedule.id }}
                  size="sm"
                  fw={600}
                >
                  <UserText>{titleOf(schedule)}</UserText>
                </RouteLink>
              </Table.Td>
              <Table.Td>
                <Next schedule={schedule} />
              </Table.Td>
              {!upcoming && (
                <>
                  <Table.Td>
                    <UserText>{timesOf(schedule)}</UserText>
                  </Table.Td>
                  <Table.Td>{stateOf(schedule)}</Table.Td>
                  <Table.Td>
                    <ScheduleActions schedule={schedule} act={act} />
                  </Table.Td>
                </>
              )}
            </Table.Tr>
          ))}
        </Table.Tbody>
      </ScrollTable>
      {onPage && (
        <Pager
          label="Pages of schedules"
          page={page}
          size={SCHEDULES_PER_PAGE}
          total={schedules.data.total}
          onPage={onPage}
        />
      )}
    </Stack>
  );
}

function Next({ schedule: { next, zone } }: { schedule: Schedule }) {
  const now = useNow(10_000);
  if (!next) return <>–</>;
  return (
    <>
      <time dateTime={next}>{formatMoment(next, zone)}</time>{' '}
      <Text span size="sm" c="dimmed">
        {formatUntil(next, now)}
      </Text>
    </>
  );
}
