/** A count and its noun: `1 case`, `55 cases`. */
export function plural(count: number, one: string, many = `${one}s`): string {
  return `${formatCount(count)} ${count === 1 ? one : many}`;
}

export function formatCount(count: number): string {
  return count.toLocaleString('en');
}

/** A unit of time and its length in microseconds. */
export interface TimeUnit {
  name: string;
  us: number;
}

const TIME_UNITS: readonly TimeUnit[] = [
  { name: 's', us: 1_000_000 },
  { name: 'ms', us: 1_000 },
  { name: 'µs', us: 1 },
  { name: 'ns', us: 0.001 },
];

const DIGITS = 3;

/** The largest unit in which a time in microseconds is at least 1. */
export function timeUnitOf(us: number): TimeUnit {
  // Rounded first: 999.96 µs is 1.00 ms.
  const rounded = Math.abs(Number(us.toPrecision(DIGITS)));
  const unit = TIME_UNITS.find((known) => rounded >= known.us * (1 - 1e-12));
  return unit ?? { name: 'µs', us: 1 };
}

/** A time in microseconds in the unit that fits, or a dash if there is none: `64.3 ms`. */
export function formatTime(us: number | null | undefined): string {
  if (us == null || !Number.isFinite(us)) return '–';
  if (Math.abs(us) >= 60e6) return formatSeconds(us / 1e6);
  const unit = timeUnitOf(us);
  return `${inUnit(us, unit)} ${unit.name}`;
}

/** A time in microseconds in the given unit, with three digits and without its name. */
export function inUnit(us: number, unit: TimeUnit): string {
  const value = us / unit.us;
  if (value === 0) return '0';
  return Math.abs(value) >= 10 ** DIGITS
    ? value.toLocaleString('en', { maximumFractionDigits: 0 })
    : value.toPrecision(DIGITS).replace(/e.*/, '');
}

/** Local date and time with seconds. */
export function formatInstant(iso: string): string {
  const date = new Date(iso);
  if (Number.isNaN(date.getTime())) return iso;
  return date.toLocaleString('en-GB', { dateStyle: 'medium', timeStyle: 'medium' });
}

const AGES: readonly [Intl.RelativeTimeFormatUnit, number][] = [
  ['day', 86_400],
  ['hour', 3_600],
  ['minute', 60],
];

/** `5 minutes ago`; `just now` within a minute; a date after a week. */
export function formatAge(iso: string, now: Date): string {
  const seconds = (now.getTime() - new Date(iso).getTime()) / 1000;
  if (Number.isNaN(seconds) || seconds > 7 * 86_400) return formatInstant(iso);
  for (const [unit, length] of AGES) {
    if (seconds >= length) {
      return new Intl.RelativeTimeFormat('en').format(-Math.floor(seconds / length), unit);
    }
  }
  return 'just now';
}

/** The duration between two instants: `0.8 s`, `2 min 5 s`. */
export function formatDuration(fromIso: string, toIso: string): string {
  const seconds = Math.max(0, (new Date(toIso).getTime() - new Date(fromIso).getTime()) / 1000);
  return Number.isNaN(seconds) ? '–' : formatSeconds(seconds);
}

function formatSeconds(seconds: number): string {
  if (seconds < 60) return `${seconds.toFixed(1)} s`;
  const whole = Math.round(seconds);
  if (whole < 3600) return `${Math.floor(whole / 60)} min ${whole % 60} s`;
  return `${Math.floor(whole / 3600)} h ${Math.floor((whole % 3600) / 60)} min`;
}

/** How long something will still take: `about 40 s left`, `about 3 min left`. */
export function formatLeft(seconds: number): string {
  if (seconds < 120) return `about ${Math.round(seconds)} s left`;
  if (seconds < 7200) return `about ${Math.round(seconds / 60)} min left`;
  return `about ${Math.round(seconds / 3600)} h left`;
}

/** A date and time in a time zone: `Monday 23 November 2026 at 03:00`. */
export function formatMoment(iso: string, zone?: string): string {
  const date = new Date(iso);
  if (Number.isNaN(date.getTime())) return iso;
  const parts = {
    weekday: 'long',
    day: 'numeric',
    month: 'long',
    year: 'numeric',
    hour: '2-digit',
    minute: '2-digit',
  } as const;
  try {
    return date.toLocaleString('en-GB', {
      ...parts,
      ...(zone && { timeZone: zone === 'Z' ? 'UTC' : zone }),
    });
  } catch {
    // The browser does not know the zone: use the local one.
    return date.toLocaleString('en-GB', parts);
  }
}

const UNITS: readonly [string, number][] = [
  ['day', 86_400],
  ['hour', 3_600],
  ['minute', 60],
];

/** The time until an instant: `in 2 days 3 hours`, `in 5 minutes`, `now`. */
export function formatUntil(iso: string, now: Date): string {
  let seconds = Math.round((new Date(iso).getTime() - now.getTime()) / 1000);
  const parts: string[] = [];
  for (const [unit, length] of UNITS) {
    const count = Math.floor(seconds / length);
    if (count > 0 && parts.length < 2) parts.push(plural(count, unit));
    seconds -= Math.max(0, count) * length;
  }
  return parts.length > 0 ? `in ${parts.join(' ')}` : seconds > 0 ? 'in less than a minute' : 'now';
}
