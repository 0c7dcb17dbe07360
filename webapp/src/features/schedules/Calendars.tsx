import { Button, Checkbox, Group, Stack, Table, Text, Textarea, TextInput } from '@mantine/core';
import { useState, type SyntheticEvent } from 'react';
import type { Calendar } from '@/shared/api';
import { Loading, ProblemAlert, ScrollTable, UserText } from '@/shared/ui';
import { useCalendars, useDeleteCalendar, useSaveCalendar } from './queries';
import { WEEKDAYS, weekdayName } from './words';

const EMPTY = { name: '', weekdays: [] as string[], days: '' };

/** Named sets of days on which schedules do not fire. */
export function Calendars() {
  const calendars = useCalendars();
  const save = useSaveCalendar();
  const remove = useDeleteCalendar();
  const [draft, setDraft] = useState(EMPTY);
  if (calendars.isPending) return <Loading what="the calendars" />;
  if (!calendars.data) {
    return <ProblemAlert title="The calendars could not be read" error={calendars.error} />;
  }

  function submit(event: SyntheticEvent) {
    event.preventDefault();
    save.mutate(
      {
        name: draft.name.trim(),
        weekdays: WEEKDAYS.filter((day) => draft.weekdays.includes(day)),
        days: draft.days.split(/[\s,;]+/).filter((day) => day !== ''),
      },
      {
        onSuccess: () => {
          setDraft(EMPTY);
        },
      },
    );
  }

  return (
    <Stack gap="md">
      {calendars.data.length > 0 && (
        <ScrollTable label="Calendars" minWidth={480}>
          <Table.Thead>
            <Table.Tr>
              <Table.Th>Calendar</Table.Th>
              <Table.Th>Days that are left out</Table.Th>
              <Table.Th aria-label="Actions" />
            </Table.Tr>
          </Table.Thead>
          <Table.Tbody>
            {calendars.data.map((calendar) => (
              <Table.Tr key={calendar.name}>
                <Table.Td>
                  <UserText>{calendar.name}</UserText>
                </Table.Td>
                <Table.Td>{inWords(calendar)}</Table.Td>
                <Table.Td>
                  <Group gap="xs" justify="flex-end" wrap="nowrap">
                    <Button
                      size="compact-xs"
                      variant="default"
                      aria-label={`Change ${calendar.name}`}
                      onClick={() => {
                        setDraft({
                          name: calendar.name,
                          weekdays: [...calendar.weekdays],
                          days: calendar.days.join('\n'),
                        });
                      }}
                    >
                      Change
                    </Button>
                    <Button
                      size="compact-xs"
                      variant="default"
                      aria-label={`Delete ${calendar.name}`}
                      onClick={() => {
                        remove.mutate(calendar.name);
                      }}
                    >
                      Delete
                    </Button>
                  </Group>
                </Table.Td>
              </Table.Tr>
            ))}
          </Table.Tbody>
        </ScrollTable>
      )}
      {remove.isError && (
        <ProblemAlert title="It was not deleted" error={remove.error} onClose={remove.reset} />
      )}
      <form onSubmit={submit}>
        <Stack gap="sm" maw={800}>
          <TextInput
            label="Name of a calendar"
            description="one that exists is changed"
            required
            value={draft.name}
            onChange={({ currentTarget: { value } }) => {
              setDraft({ ...draft, name: value });
            }}
          />
          <Checkbox.Group
            label="Weekdays to leave out"
            value={draft.weekdays}
            onChange={(weekdays) => {
              setDraft({ ...draft, weekdays });
            }}
          >
            <Group gap="md" mt={4}>
              {WEEKDAYS.map((day) => (
                <Checkbox key={day} value={day} label={weekdayName(day)} />
              ))}
            </Group>
          </Checkbox.Group>
          <Textarea
            label="Days to leave out"
            description="such as 2026-12-25, one a line"
            autosize
            minRows={2}
            maxRows={8}
            value={draft.days}
            onChange={({ currentTarget: { value } }) => {
              setDraft({ ...draft, days: value });
            }}
          />
          {save.isError && (
            <ProblemAlert title="It was not kept" error={save.error} onClose={save.reset} />
          )}
          <Group>
            <Button type="submit" variant="default" loading={save.isPending}>
              Keep the calendar
            </Button>
          </Group>
        </Stack>
      </form>
      {calendars.data.length === 0 && (
        <Text c="dimmed" size="sm">
          No calendar yet: a schedule can leave out weekends or holidays once they stand here.
        </Text>
      )}
    </Stack>
  );
}

function inWords({ weekdays, days }: Calendar): string {
  return (
    [...WEEKDAYS.filter((day) => weekdays.includes(day)).map(weekdayName), ...days].join(', ') ||
    'none'
  );
}
