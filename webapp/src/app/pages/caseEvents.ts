import type { EventMark } from '@/features/replay';
import type { CaseSignals, ResultCase, ResultParameter } from '@/shared/api';

/** The prefix of the parameters that let a device fail. */
const FAULT = 'fault.';
const DETAIL = /\.(at|for|value)$/;

/**
 * Faults of devices, and intervals and violations of conditions over time.
 *
 * @param call simulation time of the call, from which all these times count
 */
export function eventsOf(
  item: ResultCase | null | undefined,
  parameters: readonly ResultParameter[],
  signals: CaseSignals | null,
  call: number,
): EventMark[] {
  if (!item) return [];
  const values = new Map(parameters.map(({ name }, index) => [name, item.values[index] ?? '']));
  const faults = [...values]
    .filter(([name, value]) => name.startsWith(FAULT) && !DETAIL.test(name) && acts(name, value))
    .map(([name, value]): EventMark => {
      const at = Number(values.get(`${name}.at`) ?? 0);
      const lasts = Number(values.get(`${name}.for`) ?? Infinity);
      return {
        kind: 'fault',
        from: call + at,
        to: call + at + lasts,
        name,
        about: `${value} from ${at} s${Number.isFinite(lasts) ? ` for ${lasts} s` : ' to the end'}`,
      };
    });
  const conditions = item.trajectories.flatMap((result): EventMark[] => {
    const interval = signals?.conditions.find(({ name }) => name === result.name);
    if (result.verdict === 'FAIL' && result.at !== undefined) {
      return [
        {
          kind: 'violation',
          from: call + result.at,
          name: result.name,
          about: `violated at ${result.at} s`,
        },
      ];
    }
    return interval
      ? [
          {
            kind: 'interval',
            from: call + interval.from,
            to: call + interval.to,
            name: result.name,
            about: `holds from ${interval.from} to ${interval.to} s`,
          },
        ]
      : [];
  });
  return [...faults, ...conditions];
}

/** Whether the value of a fault changes anything: a scale of 1 and other numbers of 0 do not. */
function acts(name: string, value: string): boolean {
  return name.endsWith('.scale') ? Number(value) !== 1 : Number(value) !== 0;
}
