import { List, Text } from '@mantine/core';
import { formatMoment, formatUntil } from '@/shared/lib/format';
import { useNow } from '@/shared/lib/useNow';

/** Times to come in words, in the zone of their schedule. */
export function NextTimes({
  times,
  zone,
}: {
  times: readonly string[];
  zone?: string | undefined;
}) {
  const now = useNow(10_000);
  if (times.length === 0) return <Text c="dimmed">It fires no more.</Text>;
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
