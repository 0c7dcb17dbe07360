import { Button, Checkbox, Group, Stack, Table, Text, Textarea, TextInput } from '@mantine/core';
import { useState, type SyntheticEvent } from 'react';
import type { Calendar } from '@/shared/api';
import { Loading, ProblemAlert, ScrollTable, UserText } from '@/shared/ui';
import { useCalendars, useDeleteCalendar, useSaveCalendar } from './queries';
import { WEEKDAYS, weekdayName } from './words';

const EMPTY = { name: '', weekdays: [] as string[], days: '' };

/** Calendars: named sets of days on which schedules do not run. */
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
              <Table.Th>Excluded days</Table.Th>
              <Table.Th aria-label="Actions" />
            </Table.Tr>
          </Table.Thead>
          <Table.Tbody>
            {calendars.data.map((calendar) => (
              <Table.Tr key={calendar.name}>
                <Table.Td>
                  <UserText>{calendar.name}</UserText>
                </Table.Td>
                <Table.Td>{excludedDays(calendar)}</Table.Td>
                <Table.Td>
                  <Group gap="xs" justify="flex-end" wrap="nowrap">
                    <Button
                      size="compact-xs"
                      variant="default"
                      aria-label={`Edit ${calendar.name}`}
                      onClick={() => {
                        setDraft({
                          name: calendar.name,
                          weekdays: [...calendar.weekdays],
                          days: calendar.days.join('\n'),
                        });
                      }}
                    >
                      Edit
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
        <ProblemAlert
          title="The calendar was not deleted"
          error={remove.error}
          onClose={remove.reset}
        />
      )}
      <form onSubmit={submit}>
        <Stack gap="sm" maw={800}>
          <TextInput
            label="Calendar name"
            description="The name of an existing calendar changes that calendar"
            required
            value={draft.name}
            onChange={({ currentTarget: { value } }) => {
              setDraft({ ...draft, name: value });
            }}
          />
          <Checkbox.Group
            label="Excluded weekdays"
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
            label="Excluded dates"
            description="One per line, such as 2026-12-25"
            autosize
            minRows={2}
            maxRows={8}
            value={draft.days}
            onChange={({ currentTarget: { value } }) => {
              setDraft({ ...draft, days: value });
            }}
          />
          {save.isError && (
            <ProblemAlert
              title="The calendar was not saved"
              error={save.error}
              onClose={save.reset}
            />
          )}
          <Group>
            <Button type="submit" variant="default" loading={save.isPending}>
              Save calendar
            </Button>
          </Group>
        </Stack>
      </form>
      {calendars.data.length === 0 && (
        <Text c="dimmed" size="sm">
          No calendars yet. A calendar excludes days such as weekends or holidays from schedules.
        </Text>
      )}
    </Stack>
  );
}

function excludedDays({ weekdays, days }: Calendar): string {
  return (
    [...WEEKDAYS.filter((day) => weekdays.includes(day)).map(weekdayName), ...days].join(', ') ||
    'none'
  );
}
