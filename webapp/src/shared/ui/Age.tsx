import { formatAge, formatInstant } from '@/shared/lib/format';
import { useNow } from '@/shared/lib/useNow';

/** How long ago something was; the exact instant is its title. */
export function Age({ at }: { at: string }) {
  const now = useNow(10_000);
  return (
    <time dateTime={at} title={formatInstant(at)}>
      {formatAge(at, now)}
    </time>
  );
}
