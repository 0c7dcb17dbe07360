import { useQueries, type QueryKey } from '@tanstack/react-query';
import { useVirtualizer } from '@tanstack/react-virtual';
import { useRef } from 'react';

interface VirtualPages<T> {
  /** Number of items of all pages. */
  total: number;
  pageSize: number;
  rowHeight: number;
  queryKey: QueryKey;
  fetchPage: (page: number, signal: AbortSignal) => Promise<{ items: T[] }>;
}

/** Rows rendered outside the visible area. */
const OVERSCAN_ROWS = 20;

/** A long list that fetches only the visible pages and renders only the visible rows. */
export function useVirtualPages<T>({
  total,
  pageSize,
  rowHeight,
  queryKey,
  fetchPage,
}: VirtualPages<T>) {
  const scroller = useRef<HTMLDivElement>(null);
  // eslint-disable-next-line react-hooks/incompatible-library -- nothing here is memoised by the compiler
  const virtual = useVirtualizer({
    count: total,
    getScrollElement: () => scroller.current,
    estimateSize: () => rowHeight,
    overscan: OVERSCAN_ROWS,
    initialRect: { width: 1000, height: 600 },
  });
  const rows = virtual.getVirtualItems();
  const first = Math.floor((rows[0]?.index ?? 0) / pageSize);
  const last = Math.floor((rows.at(-1)?.index ?? 0) / pageSize);
  const wanted = total > 0 ? Array.from({ length: last - first + 1 }, (_, n) => first + n) : [];
  const pages = useQueries({
    queries: wanted.map((page) => ({
      queryKey: [...queryKey, 'page', page],
      queryFn: ({ signal }: { signal: AbortSignal }) => fetchPage(page, signal),
      staleTime: Infinity,
    })),
  });
  const itemAt = (index: number): T | undefined => {
    const page = wanted.indexOf(Math.floor(index / pageSize));
    return pages[page]?.data?.items[index % pageSize];
  };
  const above = rows[0]?.start ?? 0;
  const below = virtual.getTotalSize() - (rows.at(-1)?.end ?? 0);
  return {
    scroller,
    rows: rows.map(({ index }) => ({ index, item: itemAt(index) })),
    above,
    below,
    error: pages.find(({ error }) => error)?.error ?? null,
    loading: pages.some(({ isPending }) => isPending),
    scrollTo: (index: number) => {
      virtual.scrollToIndex(index, { align: 'auto' });
    },
  };
}
