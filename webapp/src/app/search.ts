import { VERDICTS } from '@/features/results';
import type { Verdict } from '@/shared/api';

/** What the addresses of the pages say after the `?`: pages count from 1 there, absent means the first. */
export interface HomeSearch {
  activities?: number;
  builds?: number;
}

export interface ActivitySearch {
  builds?: number;
}

export interface BuildSearch {
  page?: number;
  verdict?: Verdict;
}

type Raw = Record<string, unknown>;

export function homeSearch(raw: Raw): HomeSearch {
  return { ...pageIn(raw, 'activities'), ...pageIn(raw, 'builds') };
}

export function activitySearch(raw: Raw): ActivitySearch {
  return pageIn(raw, 'builds');
}

export function buildSearch(raw: Raw): BuildSearch {
  const verdict = VERDICTS.find((known) => known === raw['verdict']);
  return { ...pageIn(raw, 'page'), ...(verdict && { verdict }) };
}

/** The page from 0, as the server counts. */
export function toIndex(page: number | undefined): number {
  return (page ?? 1) - 1;
}

/** The page for an address, from 0; the first is left out, so that a page has one address. */
export function fromIndex(index: number): number | undefined {
  return index > 0 ? index + 1 : undefined;
}

/** Addresses are written by people too: what is not a page is the first one. */
function pageIn<K extends string>(raw: Raw, key: K): Partial<Record<K, number>> {
  const page = Number(raw[key]);
  const valid = Number.isSafeInteger(page) && page > 1 && page < 1_000_000;
  return (valid ? { [key]: page } : {}) as Partial<Record<K, number>>;
}
