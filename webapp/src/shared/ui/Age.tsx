import { formatAge, formatInstant } from '@/shared/lib/format';
import { useNow } from '@/shared/lib/useNow';

/** The age of an instant; the exact time is the tooltip. */
export function Age({ at }: { at: string }) {
  const now = useNow(10_000);
  return (
    <time dateTime={at} title={formatInstant(at)}>
      {formatAge(at, now)}
    </time>
  );
}
