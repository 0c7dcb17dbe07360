import type { Schedule, ScheduleRequest } from '@/shared/api';
import { formatMoment, plural } from '@/shared/lib/format';

type Misfire = Schedule['misfire'];

/** What becomes of times that are missed, as the server knows it and in words. */
export const MISFIRES: readonly { value: Misfire; label: string }[] = [
  { value: 'ONCE', label: 'one build for all of them, as soon as possible' },
  { value: 'SKIP', label: 'nothing: the next time to come counts' },
  { value: 'ALL', label: 'one build for each of them' },
];

export const WEEKDAYS = [
  'MONDAY',
  'TUESDAY',
  'WEDNESDAY',
  'THURSDAY',
  'FRIDAY',
  'SATURDAY',
  'SUNDAY',
] as const;

/** `MONDAY` as people write it. */
export function weekdayName(day: string): string {
  return day.charAt(0) + day.slice(1).toLowerCase();
}

/** When a schedule fires, as it was asked for. */
export function timesOf({ at, cron, everyMinutes, zone }: Schedule): string {
  if (cron) return `${cron} (${zone === 'Z' ? 'UTC' : zone})`;
  if (everyMinutes) return `every ${plural(everyMinutes, 'minute')}`;
  return at ? `once, ${formatMoment(at)}` : '';
}

export function stateOf({ paused, next, fired }: Schedule): string {
  if (paused) return 'Paused';
  if (next) return 'Waiting';
  return fired ? 'Done' : 'Over';
}

/** The name that people gave it, or else what it builds. */
export function titleOf({ name, model }: Schedule): string {
  return name ?? model;
}

export const KINDS = [
  { value: 'once', label: 'Once' },
  { value: 'interval', label: 'Every n minutes' },
  { value: 'cron', label: 'Calendar (cron)' },
] as const;
export type Kind = (typeof KINDS)[number]['value'];

/** When, as it is typed. */
export interface TimingDraft {
  kind: Kind;
  /** As `datetime-local` has it, without a zone. */
  at: string;
  minutes: string;
  cron: string;
  zone: string;
}

/** As the server is asked; nothing while it is not complete. */
export function timingOf(draft: TimingDraft): ScheduleRequest | undefined {
  switch (draft.kind) {
    case 'once': {
      const time = new Date(draft.at);
      return Number.isNaN(time.getTime()) ? undefined : { at: withOffset(time) };
    }
    case 'interval': {
      const time = new Date(draft.at);
      const minutes = Number(draft.minutes);
      if (!Number.isInteger(minutes) || minutes < 1) return undefined;
      return {
        everyMinutes: minutes,
        zone: draft.zone,
        ...(!Number.isNaN(time.getTime()) && { at: withOffset(time) }),
      };
    }
    case 'cron':
      return draft.cron.trim() === '' ? undefined : { cron: draft.cron.trim(), zone: draft.zone };
  }
}

/** As the clock on the wall shows it, with the zone that it is in. */
function withOffset(time: Date): string {
  const minutes = -time.getTimezoneOffset();
  const two = (value: number) => String(Math.floor(Math.abs(value))).padStart(2, '0');
  const wall = new Date(time.getTime() + minutes * 60_000).toISOString().slice(0, 19);
  return `${wall}${minutes < 0 ? '-' : '+'}${two(minutes / 60)}:${two(minutes % 60)}`;
}

/** What is often wanted. */
export const CRON_EXAMPLES: readonly { cron: string; label: string }[] = [
  { cron: '0 3 * * *', label: 'every night at 3:00' },
  { cron: '0 22 * * 1-5', label: 'Monday to Friday at 22:00' },
  { cron: '0 * * * *', label: 'every hour' },
  { cron: '30 6 1 * *', label: 'on the first of each month at 6:30' },
];
