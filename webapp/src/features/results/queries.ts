import { keepPreviousData, useQuery } from '@tanstack/react-query';
import { dataOf, useApi, type Verdict } from '@/shared/api';

/** Cases that are fetched at once: a result of 100,000 is never loaded whole. */
export const CASES_PER_PAGE = 200;

const RESULTS = 'results';

/** Which cases are shown. */
export interface CaseFilter {
  verdict?: Verdict | undefined;
  parameter?: string | undefined;
  value?: string | undefined;
}

export function useResult(buildId: string) {
  const api = useApi();
  return useQuery({
    queryKey: [RESULTS, buildId],
    queryFn: ({ signal }) =>
      dataOf(api.GET('/api/v1/builds/{id}/result', { params: { path: { id: buildId } }, signal })),
    // An accepted result never changes.
    staleTime: Infinity,
  });
}

export function useFetchCases(buildId: string, filter: CaseFilter) {
  const api = useApi();
  return {
    queryKey: [RESULTS, buildId, 'cases', filter] as const,
    fetchPage: (page: number, signal?: AbortSignal) =>
      dataOf(
        api.GET('/api/v1/builds/{id}/result/cases', {
          params: {
            path: { id: buildId },
            query: {
              page,
              size: CASES_PER_PAGE,
              ...(filter.verdict && { verdict: filter.verdict }),
              ...(filter.parameter &&
                filter.value !== undefined && {
                  parameter: filter.parameter,
                  value: filter.value,
                }),
            },
          },
          ...(signal && { signal }),
        }),
      ),
  };
}

/** The first page of a filter, which also says how many cases there are. */
export function useFirstCases(buildId: string, filter: CaseFilter) {
  const { queryKey, fetchPage } = useFetchCases(buildId, filter);
  return useQuery({
    queryKey: [...queryKey, 'page', 0],
    queryFn: ({ signal }) => fetchPage(0, signal),
    placeholderData: keepPreviousData,
    staleTime: Infinity,
  });
}

export function useStatistics(buildId: string) {
  const api = useApi();
  return useQuery({
    queryKey: [RESULTS, buildId, 'statistics'],
    queryFn: ({ signal }) =>
      dataOf(
        api.GET('/api/v1/builds/{id}/result/statistics', {
          params: { path: { id: buildId } },
          signal,
        }),
      ),
    staleTime: Infinity,
  });
}

/** Results of an activity, of one model or all, the newest first. */
export function useHistory(activityId: string, model?: string) {
  const api = useApi();
  return useQuery({
    queryKey: [RESULTS, 'history', activityId, model],
    queryFn: ({ signal }) =>
      dataOf(
        api.GET('/api/v1/activities/{id}/results', {
          params: { path: { id: activityId }, query: { size: 100, ...(model && { model }) } },
          signal,
        }),
      ),
  });
}

export function useComparison(buildId: string, other: string) {
  const api = useApi();
  return useQuery({
    queryKey: [RESULTS, buildId, 'comparison', other],
    queryFn: ({ signal }) =>
      dataOf(
        api.GET('/api/v1/builds/{id}/result/comparison', {
          params: { path: { id: buildId }, query: { with: other } },
          signal,
        }),
      ),
    staleTime: Infinity,
  });
}
