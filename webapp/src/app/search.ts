import type { RequestedOptions } from '@/features/builds';
import type { BuildState, Verdict } from '@/shared/api';
import { STATES } from '@/shared/lib/buildStates';
import { RECORDINGS } from '@/shared/lib/recordings';
import { VERDICTS } from '@/shared/lib/verdicts';

/** The query parameters of the pages. Page numbers start at 1; the first page has none. */
export interface ListSearch {
  page?: number;
}

/** A list that can be searched. */
export interface FoundSearch extends ListSearch {
  /** A part of a name. */
  search?: string;
}

export interface ActivitiesSearch extends FoundSearch {
  /** A tag of the activities. */
  tag?: string;
}

export interface BuildsSearch extends FoundSearch {
  state?: BuildState;
}

export const ACTIVITY_TABS = ['overview', 'interface', 'files', 'results', 'commits'] as const;
export type ActivityTab = (typeof ACTIVITY_TABS)[number];

export interface ActivitySearch {
  tab?: ActivityTab;
  builds?: number;
  file?: string;
  /** A page of the commits. */
  commits?: number;
  /** Id of a commit to mark. */
  commit?: string;
  /** Number of the pull or merge request whose commits are shown. */
  request?: number;
}

export const SUITE_TABS = ['cases', 'combinations', 'changes', 'application'] as const;
export type SuiteTab = (typeof SUITE_TABS)[number];

export interface SuiteSearch {
  tab?: SuiteTab;
  file?: string;
}

export const BUILD_TABS = [
  'table',
  'states',
  'score',
  'flaky',
  'graphs',
  'coverage',
  'log',
  'history',
] as const;
export type BuildTab = (typeof BUILD_TABS)[number];

export interface BuildSearch {
  tab?: BuildTab;
  verdict?: Verdict;
  parameter?: string;
  value?: string;
  case?: number;
  file?: string;
}

/** What a new schedule builds, a suite or a model of an activity, and the options of its builds. */
export interface NewScheduleSearch extends RequestedOptions {
  suite?: string;
  activity?: string;
  model?: string;
}

/** The moment of a case that the replay shows first. */
export interface ReplaySearch {
  /** Name of a trajectory condition. */
  condition?: string;
  /** Seconds after the call. */
  at?: number;
}

export const HISTORY_POINTS = ['COMMITS', 'BUILDS'] as const;

/** A case by its number in a build, default the one with the newest result. */
export interface CaseHistorySearch extends ListSearch {
  build?: string;
  case?: number;
  points?: (typeof HISTORY_POINTS)[number];
}

export interface CompareSearch {
  with?: string;
  /** Index of a group of differences. */
  group?: number;
  /** A page of its cases, from 1. */
  page?: number;
  /** Number of the case whose replays are shown, and that in the other build. */
  case?: number;
  other?: number;
  /** Seconds after the call of the first divergent step. */
  at?: number;
}

export interface SignInSearch {
  /** The page to open after signing in. */
  to?: string;
  link?: string;
}

type Raw = Record<string, unknown>;

const RECORDED_CASES = RECORDINGS.flatMap(({ value }) => (value === '' ? [] : [value]));

export function listSearch(raw: Raw): ListSearch {
  return numberIn(raw, 'page', 2);
}

export function foundSearch(raw: Raw): FoundSearch {
  return { ...listSearch(raw), ...textIn(raw, 'search') };
}

export function activitiesSearch(raw: Raw): ActivitiesSearch {
  return { ...foundSearch(raw), ...textIn(raw, 'tag') };
}

export function buildsSearch(raw: Raw): BuildsSearch {
  return { ...foundSearch(raw), ...choiceIn(raw, 'state', STATES) };
}

export function activitySearch(raw: Raw): ActivitySearch {
  return {
    ...choiceIn(raw, 'tab', ACTIVITY_TABS),
    ...numberIn(raw, 'builds', 2),
    ...textIn(raw, 'file'),
    ...numberIn(raw, 'commits', 2),
    ...textIn(raw, 'commit'),
    ...numberIn(raw, 'request', 1),
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
  return {
    ...textIn(raw, 'suite'),
    ...textIn(raw, 'activity'),
    ...textIn(raw, 'model'),
    ...numberIn(raw, 'priority', -100),
    ...numberIn(raw, 'shards', 2),
    ...numberIn(raw, 'retries', 0),
    ...textIn(raw, 'toolchain'),
    ...textsIn(raw, 'labels'),
    ...choiceIn(raw, 'recordings', RECORDED_CASES),
    ...(raw.explain === true && { explain: true }),
    ...(raw.ros === 'SYSTEM' && { ros: raw.ros }),
  };
}

export function replaySearch(raw: Raw): ReplaySearch {
  return { ...textIn(raw, 'condition'), ...secondsIn(raw, 'at') };
}

export function caseHistorySearch(raw: Raw): CaseHistorySearch {
  return {
    ...listSearch(raw),
    ...textIn(raw, 'build'),
    ...numberIn(raw, 'case', 1),
    ...choiceIn(raw, 'points', HISTORY_POINTS),
  };
}

export function compareSearch(raw: Raw): CompareSearch {
  return {
    ...textIn(raw, 'with'),
    ...numberIn(raw, 'group', 0),
    ...numberIn(raw, 'page', 2),
    ...numberIn(raw, 'case', 1),
    ...numberIn(raw, 'other', 1),
    ...secondsIn(raw, 'at'),
  };
}

export function signInSearch(raw: Raw): SignInSearch {
  return { ...textIn(raw, 'to'), ...textIn(raw, 'link') };
}

/** The page number of the server, from 0. */
export function toIndex(page: number | undefined): number {
  return (page ?? 1) - 1;
}

/** The page number of an address; undefined for the first page, so that a page has one address. */
export function fromIndex(index: number): number | undefined {
  return index > 0 ? index + 1 : undefined;
}

/** Removes absent and empty parameters. */
export function withoutAbsent<T extends object>(search: {
  [K in keyof T]: T[K] | undefined;
}): T {
  return Object.fromEntries(
    Object.entries(search).filter(([, value]) => value !== undefined && value !== ''),
  ) as T;
}

/** People edit addresses: an invalid number is ignored. */
function numberIn<K extends string>(raw: Raw, key: K, least: number): Partial<Record<K, number>> {
  const number = raw[key] === undefined ? NaN : Number(raw[key]);
  const valid = Number.isSafeInteger(number) && number >= least && number < 10_000_000;
  return (valid ? { [key]: number } : {}) as Partial<Record<K, number>>;
}

function secondsIn<K extends string>(raw: Raw, key: K): Partial<Record<K, number>> {
  const seconds = raw[key] === undefined ? NaN : Number(raw[key]);
  return (Number.isFinite(seconds) ? { [key]: seconds } : {}) as Partial<Record<K, number>>;
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
  // The router parses numbers, but the value of a test parameter is a text.
  const value = typeof raw[key] === 'number' ? String(raw[key]) : raw[key];
  return (typeof value === 'string' && value !== '' ? { [key]: value } : {}) as Partial<
    Record<K, string>
  >;
}

function textsIn<K extends string>(raw: Raw, key: K): Partial<Record<K, string[]>> {
  const values = Array.isArray(raw[key]) ? raw[key].map(String) : [];
  return (values.length > 0 ? { [key]: values } : {}) as Partial<Record<K, string[]>>;
}
