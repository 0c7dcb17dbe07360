import { List, Text } from '@mantine/core';
import { formatMoment, formatUntil } from '@/shared/lib/format';
import { useNow } from '@/shared/lib/useNow';

/** The next times of a schedule, in its time zone. */
export function NextTimes({
  times,
  zone,
}: {
  times: readonly string[];
  zone?: string | undefined;
}) {
  const now = useNow(10_000);
  if (times.length === 0) return <Text c="dimmed">The schedule has no further times.</Text>;
  return (
    <List type="ordered" size="sm" spacing={2} aria-label="Next times">
      {times.map((time) => (
        <List.Item key={time}>
          <time dateTime={time}>{formatMoment(time, zone)}</time>{' '}
          <Text span size="sm" c="dimmed">
            {formatUntil(time, now)}
          </Text>
        </List.Item>
      ))}
    </List>
  );
}
