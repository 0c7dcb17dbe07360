import type { Schedule, ScheduleRequest } from '@/shared/api';
import { formatMoment, plural } from '@/shared/lib/format';

type Misfire = Schedule['misfire'];

/** How missed times are handled. */
export const MISFIRES: readonly { value: Misfire; label: string }[] = [
  { value: 'ONCE', label: 'Build once as soon as possible' },
  { value: 'SKIP', label: 'Skip' },
  { value: 'ALL', label: 'Build once for each missed time' },
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

/** `Monday` for `MONDAY`. */
export function weekdayName(day: string): string {
  return day.charAt(0) + day.slice(1).toLowerCase();
}

/** The times of a schedule, such as `every 5 minutes`. */
export function timesOf({ at, cron, everyMinutes, zone }: Schedule): string {
  if (cron) return `${cron} (${zone === 'Z' ? 'UTC' : zone})`;
  if (everyMinutes) return `every ${plural(everyMinutes, 'minute')}`;
  return at ? `once, ${formatMoment(at)}` : '';
}

export function stateOf({ paused, next, fired }: Schedule): string {
  if (paused) return 'Paused';
  if (next) return 'Waiting';
  return fired ? 'Done' : 'Expired';
}

/** The name of the schedule; default: the test model. */
export function titleOf({ name, model }: Schedule): string {
  return name ?? model;
}

export const KINDS = [
  { value: 'once', label: 'Once' },
  { value: 'interval', label: 'Interval' },
  { value: 'cron', label: 'Cron' },
] as const;
export type Kind = (typeof KINDS)[number]['value'];

/** The fields of the form. */
export interface TimingDraft {
  kind: Kind;
  /** Value of a `datetime-local` field, without a time zone. */
  at: string;
  minutes: string;
  cron: string;
  zone: string;
}

/** The times as the server takes them; undefined if the form is incomplete. */
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

/** Local time with its offset from UTC. */
function withOffset(time: Date): string {
  const minutes = -time.getTimezoneOffset();
  const two = (value: number) => String(Math.floor(Math.abs(value))).padStart(2, '0');
  const local = new Date(time.getTime() + minutes * 60_000).toISOString().slice(0, 19);
  return `${local}${minutes < 0 ? '-' : '+'}${two(minutes / 60)}:${two(minutes % 60)}`;
}

/** Examples that fill in the field. */
export const CRON_EXAMPLES: readonly { cron: string; label: string }[] = [
  { cron: '0 3 * * *', label: 'Every day at 3:00' },
  { cron: '0 22 * * 1-5', label: 'Monday to Friday at 22:00' },
  { cron: '0 * * * *', label: 'Every hour' },
  { cron: '30 6 1 * *', label: 'First day of the month at 6:30' },
];
