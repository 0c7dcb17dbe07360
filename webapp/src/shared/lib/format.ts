/** A count and its noun: `1 case`, `55 cases`. */
export function plural(count: number, one: string, many = `${one}s`): string {
  return `${formatCount(count)} ${count === 1 ? one : many}`;
}

export function formatCount(count: number): string {
  return count.toLocaleString('en');
}

/** A measured time with three decimals, or a dash if there is none. */
export function formatTime(value: number | null | undefined): string {
  if (value == null || !Number.isFinite(value)) return '–';
  return value.toLocaleString('en', { minimumFractionDigits: 3, maximumFractionDigits: 3 });
}

/** `µs` for `us`, the unit of result documents. */
export function formatUnit(unit: string | null | undefined): string {
  return unit == null || unit === 'us' ? 'µs' : unit;
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
  if (Number.isNaN(seconds)) return '–';
  if (seconds < 60) return `${seconds.toFixed(1)} s`;
  const whole = Math.round(seconds);
  return `${Math.floor(whole / 60)} min ${whole % 60} s`;
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
