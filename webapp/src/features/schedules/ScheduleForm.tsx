import {
  Button,
  Checkbox,
  Group,
  NativeSelect,
  NumberInput,
  SegmentedControl,
  SimpleGrid,
  Stack,
  Text,
  TextInput,
} from '@mantine/core';
import { useDebouncedValue } from '@mantine/hooks';
import { useState, type ReactNode, type SyntheticEvent } from 'react';
import type { Schedule, ScheduleRequest } from '@/shared/api';
import { Loading, ProblemAlert, Section } from '@/shared/ui';
import { NextTimes } from './NextTimes';
import { useCalendars, useCreateSchedule, usePreview } from './queries';
import { CRON_EXAMPLES, KINDS, MISFIRES, timingOf, type TimingDraft } from './words';

const DEBOUNCE_MS = 300;
const MISFIRE = 'ONCE';

interface ScheduleFormProps {
  /** What to build and the options of the build. */
  subject: ScheduleRequest;
  /** Whether the subject is complete. */
  ready: boolean;
  /** The fields of the subject. */
  children: ReactNode;
  onCreated: (schedule: Schedule) => void;
}

/** A new schedule, with a preview of its next times. */
export function ScheduleForm({ subject, ready, children, onCreated }: ScheduleFormProps) {
  const create = useCreateSchedule();
  const [name, setName] = useState('');
  const [timing, setTiming] = useState<TimingDraft>(() => ({
    kind: 'cron',
    at: '',
    minutes: '60',
    cron: CRON_EXAMPLES[0]?.cron ?? '',
    zone: Intl.DateTimeFormat().resolvedOptions().timeZone,
  }));
  const [misfire, setMisfire] = useState<Schedule['misfire']>(MISFIRE);
  const [leaveOut, setLeaveOut] = useState<string[]>([]);
  const when = timingOf(timing);

  function submit(event: SyntheticEvent) {
    event.preventDefault();
    if (!when || !ready) return;
    create.mutate(
      {
        ...subject,
        ...when,
        ...(name.trim() !== '' && { name: name.trim() }),
        misfire,
        ...(leaveOut.length > 0 && { leaveOut }),
      },
      { onSuccess: onCreated },
    );
  }

  return (
    <form onSubmit={submit}>
      <SimpleGrid cols={{ base: 1, md: 2 }} spacing="xl">
        <Stack gap="lg">
          <Section title="Build">
            {children}
            <TextInput
              label="Name"
              description="Default: the name of the test model"
              maxLength={200}
              value={name}
              onChange={(event) => {
                setName(event.currentTarget.value);
              }}
            />
          </Section>
          <Section title="Time">
            <TimingFields timing={timing} onTiming={setTiming} />
            <NativeSelect
              label="Missed times"
              description="If no server was running or the schedule was paused"
              value={misfire}
              data={[...MISFIRES]}
              onChange={({ currentTarget: { value } }) => {
                setMisfire(MISFIRES.find((known) => known.value === value)?.value ?? MISFIRE);
              }}
            />
            <Calendars leaveOut={leaveOut} onLeaveOut={setLeaveOut} />
          </Section>
        </Stack>
        <Section title="Next times">
          <Preview when={when} leaveOut={leaveOut} zone={timing.zone} />
        </Section>
      </SimpleGrid>
      <Stack gap="sm" mt="lg">
        {create.isError && (
          <ProblemAlert
            title="The schedule was not created"
            error={create.error}
            onClose={create.reset}
          />
        )}
        <Group>
          <Button type="submit" loading={create.isPending} disabled={!when || !ready}>
            Create schedule
          </Button>
        </Group>
      </Stack>
    </form>
  );
}

interface TimingFieldsProps {
  timing: TimingDraft;
  onTiming: (timing: TimingDraft) => void;
}

function TimingFields({ timing, onTiming }: TimingFieldsProps) {
  const set = (change: Partial<TimingDraft>) => {
    onTiming({ ...timing, ...change });
  };
  return (
    <>
      <SegmentedControl
        aria-label="Kind of schedule"
        fullWidth
        value={timing.kind}
        onChange={(kind) => {
          set({ kind });
        }}
        data={[...KINDS]}
      />
      {timing.kind === 'cron' && (
        <>
          <TextInput
            label="Cron expression"
            description="minute, hour, day of month, month, day of week"
            styles={{ input: { fontFamily: 'var(--mantine-font-family-monospace)' } }}
            required
            value={timing.cron}
            onChange={(event) => {
              set({ cron: event.currentTarget.value });
            }}
          />
          <Group gap="xs" role="group" aria-label="Examples of cron expressions">
            {CRON_EXAMPLES.map(({ cron, label }) => (
              <Button
                key={cron}
                size="compact-xs"
                variant="default"
                onClick={() => {
                  set({ cron });
                }}
              >
                {label}
              </Button>
            ))}
          </Group>
        </>
      )}
      {timing.kind === 'interval' && (
        <NumberInput
          label="Interval (minutes)"
          min={1}
          required
          value={timing.minutes}
          onChange={(minutes) => {
            set({ minutes: String(minutes) });
          }}
        />
      )}
      {timing.kind !== 'cron' && (
        <TextInput
          type="datetime-local"
          label={timing.kind === 'once' ? 'Time' : 'First time'}
          description={`Time zone ${Intl.DateTimeFormat().resolvedOptions().timeZone}${timing.kind === 'once' ? '' : '; default: now'}`}
          required={timing.kind === 'once'}
          value={timing.at}
          onChange={(event) => {
            set({ at: event.currentTarget.value });
          }}
        />
      )}
      {timing.kind === 'cron' && (
        <NativeSelect
          label="Time zone"
          value={timing.zone}
          data={zones(timing.zone)}
          onChange={(event) => {
            set({ zone: event.currentTarget.value });
          }}
        />
      )}
    </>
  );
}

function zones(own: string): string[] {
  return [...new Set([own, 'UTC', ...Intl.supportedValuesOf('timeZone')])];
}

interface CalendarsProps {
  leaveOut: string[];
  onLeaveOut: (names: string[]) => void;
}

function Calendars({ leaveOut, onLeaveOut }: CalendarsProps) {
  const calendars = useCalendars();
  if (!calendars.data || calendars.data.length === 0) {
    return (
      <Text size="sm" c="dimmed">
        Calendars with excluded days can be added on the schedules page.
      </Text>
    );
  }
  return (
    <Checkbox.Group label="Excluded days" value={leaveOut} onChange={onLeaveOut}>
      <Group gap="md" mt={4}>
        {calendars.data.map(({ name }) => (
          <Checkbox key={name} value={name} label={name} />
        ))}
      </Group>
    </Checkbox.Group>
  );
}

interface PreviewProps {
  when: ScheduleRequest | undefined;
  leaveOut: string[];
  zone: string;
}

function Preview({ when, leaveOut, zone }: PreviewProps) {
  const [debounced] = useDebouncedValue(
    when && JSON.stringify({ ...when, ...(leaveOut.length > 0 && { leaveOut }) }),
    DEBOUNCE_MS,
  );
  const times = usePreview(
    debounced === undefined ? undefined : (JSON.parse(debounced) as ScheduleRequest),
  );
  if (when === undefined) return <Text c="dimmed">Enter a time to see the next times.</Text>;
  if (times.error) return <ProblemAlert title="Invalid time" error={times.error} />;
  if (!times.data) return <Loading what="the next times" />;
  if (times.data.length === 0) return <Text c="dimmed">This schedule would never run.</Text>;
  return <NextTimes times={times.data} zone={when.at && !when.everyMinutes ? undefined : zone} />;
}
