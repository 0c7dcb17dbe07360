import type { Verdict } from '@/shared/api';
import { VERDICTS } from '@/shared/lib/verdicts';

/** What the addresses of the pages say after the `?`: pages count from 1 there, absent means the first. */
export interface ListSearch {
  page?: number;
}

export const ACTIVITY_TABS = ['overview', 'interface', 'files', 'results'] as const;
export type ActivityTab = (typeof ACTIVITY_TABS)[number];

export interface ActivitySearch {
  tab?: ActivityTab;
  builds?: number;
  file?: string;
}

export const SUITE_TABS = ['cases', 'combinations', 'changes', 'application'] as const;
export type SuiteTab = (typeof SUITE_TABS)[number];

export interface SuiteSearch {
  tab?: SuiteTab;
  file?: string;
}

export const BUILD_TABS = ['table', 'graphs', 'coverage', 'log', 'history'] as const;
export type BuildTab = (typeof BUILD_TABS)[number];

export interface BuildSearch {
  tab?: BuildTab;
  verdict?: Verdict;
  parameter?: string;
  value?: string;
  case?: number;
  file?: string;
}

/** What is to be built at a time to come: a suite as it is, or a model of an activity. */
export interface NewScheduleSearch {
  suite?: string;
  activity?: string;
  model?: string;
}

export interface CompareSearch {
  with?: string;
}

export interface SignInSearch {
  /** Where to go then. */
  to?: string;
  link?: string;
}

type Raw = Record<string, unknown>;

export function listSearch(raw: Raw): ListSearch {
  return numberIn(raw, 'page', 2);
}

export function activitySearch(raw: Raw): ActivitySearch {
  return {
    ...choiceIn(raw, 'tab', ACTIVITY_TABS),
    ...numberIn(raw, 'builds', 2),
    ...textIn(raw, 'file'),
  };
}

export function suiteSearch(raw: Raw): SuiteSearch {
  return { ...choiceIn(raw, 'tab', SUITE_TABS), ...textIn(raw, 'file') };
}

export function buildSearch(raw: Raw): BuildSearch {
  return {
    ...choiceIn(raw, 'tab', BUILD_TABS),
    ...choiceIn(raw, 'verdict', VERDICTS),
    ...textIn(raw, 'parameter'),
    ...textIn(raw, 'value'),
    ...numberIn(raw, 'case', 1),
    ...textIn(raw, 'file'),
  };
}

export function newScheduleSearch(raw: Raw): NewScheduleSearch {
  return { ...textIn(raw, 'suite'), ...textIn(raw, 'activity'), ...textIn(raw, 'model') };
}

export function compareSearch(raw: Raw): CompareSearch {
  return textIn(raw, 'with');
}

export function signInSearch(raw: Raw): SignInSearch {
  return { ...textIn(raw, 'to'), ...textIn(raw, 'link') };
}

/** The page from 0, as the server counts. */
export function toIndex(page: number | undefined): number {
  return (page ?? 1) - 1;
}

/** The page for an address, from 0; the first is left out, so that a page has one address. */
export function fromIndex(index: number): number | undefined {
  return index > 0 ? index + 1 : undefined;
}

/** What is absent leaves no trace in the address. */
export function withoutAbsent<T extends object>(search: {
  [K in keyof T]: T[K] | undefined;
}): T {
  return Object.fromEntries(
    Object.entries(search).filter(([, value]) => value !== undefined && value !== ''),
  ) as T;
}

/** Addresses are written by people too: what is no such number is left out. */
function numberIn<K extends string>(raw: Raw, key: K, least: number): Partial<Record<K, number>> {
  const number = Number(raw[key]);
  const valid = Number.isSafeInteger(number) && number >= least && number < 10_000_000;
  return (valid ? { [key]: number } : {}) as Partial<Record<K, number>>;
}

function choiceIn<K extends string, V extends string>(
  raw: Raw,
  key: K,
  choices: readonly V[],
): Partial<Record<K, V>> {
  const chosen = choices.find((choice) => choice === raw[key]);
  return (chosen ? { [key]: chosen } : {}) as Partial<Record<K, V>>;
}

function textIn<K extends string>(raw: Raw, key: K): Partial<Record<K, string>> {
  // A number in an address is read as a number; the value that it stands for is its text.
  const value = typeof raw[key] === 'number' ? String(raw[key]) : raw[key];
  return (typeof value === 'string' && value !== '' ? { [key]: value } : {}) as Partial<
    Record<K, string>
  >;
}
