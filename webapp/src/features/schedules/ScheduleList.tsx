import { Button, Stack, Table, Text } from '@mantine/core';
import { formatInstant } from '@/shared/lib/format';
import { Loading, Pager, ProblemAlert, RouteLink, ScrollTable } from '@/shared/ui';
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
  const items = schedules.data.items.filter(({ fired }) => !upcoming || !fired);
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
            <Table.Th>When</Table.Th>
            <Table.Th>Suite</Table.Th>
            <Table.Th>State</Table.Th>
            <Table.Th />
          </Table.Tr>
        </Table.Thead>
        <Table.Tbody>
          {items.map((schedule) => (
            <Table.Tr key={schedule.id}>
              <Table.Td>{formatInstant(schedule.at)}</Table.Td>
              <Table.Td>
                <RouteLink to="/suites/$suiteId" params={{ suiteId: schedule.suiteId }} size="sm">
                  Test cases
                </RouteLink>
              </Table.Td>
              <Table.Td>{schedule.fired ? 'Requested' : 'Waiting'}</Table.Td>
              <Table.Td ta="right">
                {!schedule.fired && (
                  <Button
                    size="compact-xs"
                    variant="default"
                    aria-label={`Give up the build of ${formatInstant(schedule.at)}`}
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
