import { Button, Stack, Table, Text } from '@mantine/core';
import { formatInstant } from '@/shared/lib/format';
import type { Schedule } from '@/shared/api';
import { Loading, Pager, ProblemAlert, RouteLink, ScrollTable, UserText } from '@/shared/ui';
import { SCHEDULES_PER_PAGE, useDeleteSchedule, useSchedules } from './queries';

interface ScheduleListProps {
  page: number;
  onPage?: (page: number) => void;
  /** Whether only what is still to come is listed. */
  upcoming?: boolean;
}

export function ScheduleList({ page, onPage, upcoming = false }: ScheduleListProps) {
  const schedules = useSchedules(page);
  const remove = useDeleteSchedule();
  if (schedules.isPending) return <Loading what="schedules" />;
  if (!schedules.data) {
    return <ProblemAlert title="The schedules could not be read" error={schedules.error} />;
  }
  const items = schedules.data.items.filter(({ next, paused }) => !upcoming || (next && !paused));
  if (items.length === 0) {
    return <Text c="dimmed">{upcoming ? 'Nothing is scheduled.' : 'No schedule yet.'}</Text>;
  }
  return (
    <Stack gap="xs">
      {remove.isError && (
        <ProblemAlert
          title="The schedule was not given up"
          error={remove.error}
          onClose={remove.reset}
        />
      )}
      <ScrollTable label="Schedules" minWidth={320}>
        <Table.Thead>
          <Table.Tr>
            <Table.Th>Next</Table.Th>
            <Table.Th>Times</Table.Th>
            <Table.Th>Builds</Table.Th>
            <Table.Th>State</Table.Th>
            <Table.Th aria-label="Actions" />
          </Table.Tr>
        </Table.Thead>
        <Table.Tbody>
          {items.map((schedule) => (
            <Table.Tr key={schedule.id}>
              <Table.Td>{schedule.next ? formatInstant(schedule.next) : '–'}</Table.Td>
              <Table.Td>
                <UserText>{timesOf(schedule)}</UserText>
              </Table.Td>
              <Table.Td>
                {schedule.suiteId ? (
                  <RouteLink to="/suites/$suiteId" params={{ suiteId: schedule.suiteId }} size="sm">
                    Test cases
                  </RouteLink>
                ) : (
                  <UserText>{schedule.model ?? ''}</UserText>
                )}
              </Table.Td>
              <Table.Td>{stateOf(schedule)}</Table.Td>
              <Table.Td ta="right">
                {schedule.next && (
                  <Button
                    size="compact-xs"
                    variant="default"
                    aria-label={`Give up the build of ${formatInstant(schedule.next)}`}
                    onClick={() => {
                      remove.mutate(schedule.id);
                    }}
                  >
                    Give up
                  </Button>
                )}
              </Table.Td>
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

/** When it fires, as it was asked for. */
function timesOf({ at, cron, everyMinutes, zone }: Schedule): string {
  if (cron) return `${cron} (${zone ?? 'UTC'})`;
  if (everyMinutes) return `every ${everyMinutes} min`;
  return at ? 'once' : '';
}

function stateOf({ paused, next, fired }: Schedule): string {
  if (paused) return 'Paused';
  if (next) return 'Waiting';
  return fired ? 'Requested' : 'Over';
}
