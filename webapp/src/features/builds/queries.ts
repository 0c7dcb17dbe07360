import { keepPreviousData, useMutation, useQuery, useQueryClient } from '@tanstack/react-query';
import { dataOf, useApi, type Build, type BuildRequest, type BuildState } from '@/shared/api';
import { isFinished } from './state';

const BUILDS = ['builds'] as const;

/** Page size of the list. */
export const BUILDS_PER_PAGE = 20;

const LIST_REFRESH_MS = 5_000;
const LIVE_LIST_REFRESH_MS = 1_000;
/** How long the server may hold a long poll. */
const LONG_POLL_S = 20;
/** Minimum time between two polls, in case the server answers at once. */
const POLL_INTERVAL_MS = 300;

/** Which builds are listed. */
export interface BuildFilter {
  activityId?: string | undefined;
  /** A part of the name of the activity or of the test model. */
  search?: string | undefined;
  state?: BuildState | undefined;
}

/** A page of the builds that match, newest first; pages count from 0. */
export function useBuilds(page: number, filter: BuildFilter = {}, size = BUILDS_PER_PAGE) {
  const api = useApi();
  const { activityId, search, state } = filter;
  return useQuery({
    queryKey: [...BUILDS, 'page', page, size, activityId, search, state],
    queryFn: ({ signal }) =>
      dataOf(
        api.GET('/api/v1/builds', {
          params: {
            query: {
              page,
              size,
              ...(activityId != null && { activityId }),
              ...(search && { search }),
              ...(state && { state }),
            },
          },
          signal,
        }),
      ),
    placeholderData: keepPreviousData,
    refetchInterval: ({ state }) =>
      state.data?.items.every(isFinished) ? LIST_REFRESH_MS : LIVE_LIST_REFRESH_MS,
  });
}

/** One build, updated by long polls until it has ended. */
export function useBuild(id: string) {
  const api = useApi();
  const cache = useQueryClient();
  const queryKey = [...BUILDS, 'one', id];
  return useQuery({
    queryKey,
    queryFn: ({ signal }) => {
      const known = cache.getQueryData<Build>(queryKey);
      const wait =
        known && !isFinished(known) && !cache.getQueryState(queryKey)?.isInvalidated
          ? { waitForChangeSince: known.version, timeoutS: LONG_POLL_S }
          : {};
      return dataOf(
        api.GET('/api/v1/builds/{id}', { params: { path: { id }, query: wait }, signal }),
      );
    },
    refetchInterval: ({ state }) =>
      !state.data || state.error || isFinished(state.data) ? false : POLL_INTERVAL_MS,
  });
}

/** The part of the log that belongs to one case. */
export function useCaseLog(buildId: string, no: number) {
  const api = useApi();
  return useQuery({
    queryKey: [...BUILDS, 'one', buildId, 'case-log', no],
    queryFn: async ({ signal }) =>
      // The client has no data for an empty body.
      (await dataOf(
        api.GET('/api/v1/builds/{id}/cases/{no}/log', {
          params: { path: { id: buildId, no } },
          parseAs: 'text',
          signal,
        }),
      )) ?? '',
  });
}

/** Requests a build of a suite. */
export function useRequestBuild() {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: (body: BuildRequest) => dataOf(api.POST('/api/v1/builds', { body })),
    onSuccess: () => cache.invalidateQueries({ queryKey: BUILDS }),
  });
}

export function useCancelBuild(id: string) {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: () => dataOf(api.POST('/api/v1/builds/{id}/cancel', { params: { path: { id } } })),
    onSuccess: () => cache.invalidateQueries({ queryKey: BUILDS }),
  });
}
