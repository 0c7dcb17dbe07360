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
import { useCalendars, useMakeSchedule, usePreview } from './queries';
import { CRON_EXAMPLES, KINDS, MISFIRES, timingOf, type TimingDraft } from './words';

const SETTLE_MS = 300;
const MISFIRE = 'ONCE';

interface ScheduleFormProps {
  /** What is built, and how: the parts of the request that are not about time. */
  subject: ScheduleRequest;
  /** Whether what is built is chosen. */
  ready: boolean;
  /** The fields for it. */
  children: ReactNode;
  onMade: (schedule: Schedule) => void;
}

/** When something is built; the next times stand beside it while it is typed. */
export function ScheduleForm({ subject, ready, children, onMade }: ScheduleFormProps) {
  const make = useMakeSchedule();
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
    make.mutate(
      {
        ...subject,
        ...when,
        ...(name.trim() !== '' && { name: name.trim() }),
        misfire,
        ...(leaveOut.length > 0 && { leaveOut }),
      },
      { onSuccess: onMade },
    );
  }

  return (
    <form onSubmit={submit}>
      <SimpleGrid cols={{ base: 1, md: 2 }} spacing="xl">
        <Stack gap="lg">
          <Section title="What">
            {children}
            <TextInput
              label="Name"
              description="for people; empty for the name of the test model"
              maxLength={200}
              value={name}
              onChange={(event) => {
                setName(event.currentTarget.value);
              }}
            />
          </Section>
          <Section title="When">
            <TimingFields timing={timing} onTiming={setTiming} />
            <NativeSelect
              label="Times that are missed"
              description="while no server runs, or the schedule is paused"
              value={misfire}
              data={[...MISFIRES]}
              onChange={({ currentTarget: { value } }) => {
                setMisfire(MISFIRES.find((known) => known.value === value)?.value ?? MISFIRE);
              }}
            />
            <LeftOut leaveOut={leaveOut} onLeaveOut={setLeaveOut} />
          </Section>
        </Stack>
        <Section title="Next times">
          <Preview when={when} leaveOut={leaveOut} zone={timing.zone} />
        </Section>
      </SimpleGrid>
      <Stack gap="sm" mt="lg">
        {make.isError && (
          <ProblemAlert title="It was not scheduled" error={make.error} onClose={make.reset} />
        )}
        <Group>
          <Button type="submit" loading={make.isPending} disabled={!when || !ready}>
            Schedule
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
        aria-label="Kind of times"
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
          label="Minutes from one to the next"
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
          label={timing.kind === 'once' ? 'At' : 'First time'}
          description={`in ${Intl.DateTimeFormat().resolvedOptions().timeZone}${timing.kind === 'once' ? '' : '; empty for now'}`}
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

interface LeftOutProps {
  leaveOut: string[];
  onLeaveOut: (names: string[]) => void;
}

function LeftOut({ leaveOut, onLeaveOut }: LeftOutProps) {
  const calendars = useCalendars();
  if (!calendars.data || calendars.data.length === 0) {
    return (
      <Text size="sm" c="dimmed">
        Calendars of days to leave out are made on the page of schedules.
      </Text>
    );
  }
  return (
    <Checkbox.Group label="Leave out the days of" value={leaveOut} onChange={onLeaveOut}>
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
  const [settled] = useDebouncedValue(
    when && JSON.stringify({ ...when, ...(leaveOut.length > 0 && { leaveOut }) }),
    SETTLE_MS,
  );
  const times = usePreview(
    settled === undefined ? undefined : (JSON.parse(settled) as ScheduleRequest),
  );
  if (when === undefined) return <Text c="dimmed">Say when, and the next times stand here.</Text>;
  if (times.error) return <ProblemAlert title="No such times" error={times.error} />;
  if (!times.data) return <Loading what="the next times" />;
  if (times.data.length === 0) return <Text c="dimmed">It would never fire.</Text>;
  return <NextTimes times={times.data} zone={when.at && !when.everyMinutes ? undefined : zone} />;
}
