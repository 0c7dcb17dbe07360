import { Group, Pagination, Text } from '@mantine/core';
import { formatCount } from '@/shared/lib/format';

interface PagerProps {
  label: string;
  /** From 0, as in the server. */
  page: number;
  size: number;
  total: number;
  onPage: (page: number) => void;
}

/** Page navigation of a list; not shown for a single page. */
export function Pager({ label, page, size, total, onPage }: PagerProps) {
  const pages = Math.ceil(total / size);
  if (pages <= 1) return null;
  const first = page * size + 1;
  const last = Math.min(total, first + size - 1);
  return (
    <Group component="nav" justify="space-between" aria-label={label}>
      <Text size="sm" c="dimmed">
        {formatCount(first)} to {formatCount(last)} of {formatCount(total)}
      </Text>
      <Pagination
        size="sm"
        total={pages}
        value={page + 1}
        onChange={(next) => {
          onPage(next - 1);
        }}
        getItemProps={(item) => ({ 'aria-label': `Page ${item}` })}
        getControlProps={(control) => ({ 'aria-label': `${control} page` })}
      />
    </Group>
  );
}
