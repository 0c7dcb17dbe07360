import { keepPreviousData, useQuery, useQueryClient } from '@tanstack/react-query';
import { useEffect, useRef } from 'react';
import { dataOf, useApi, type Verdict } from '@/shared/api';

/** Page size: large results are loaded page by page. */
export const CASES_PER_PAGE = 200;

const RESULTS = 'results';

/** The filter of the cases. */
export interface CaseFilter {
  verdict?: Verdict | undefined;
  parameter?: string | undefined;
  value?: string | undefined;
}

export function useResult(buildId: string, enabled = true) {
  const api = useApi();
  return useQuery({
    queryKey: [RESULTS, buildId],
    queryFn: ({ signal }) =>
      dataOf(api.GET('/api/v1/builds/{id}/result', { params: { path: { id: buildId } }, signal })),
    enabled,
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

/** What failed, in groups, and since which build. */
export function useFailures(buildId: string, enabled: boolean) {
  const api = useApi();
  return useQuery({
    queryKey: [RESULTS, buildId, 'failures'],
    queryFn: ({ signal }) =>
      dataOf(
        api.GET('/api/v1/builds/{id}/result/failures', {
          params: { path: { id: buildId } },
          signal,
        }),
      ),
    enabled,
    staleTime: Infinity,
  });
}

/** The first page of the filtered cases, with their total number. */
export function useFirstCases(buildId: string, filter: CaseFilter, enabled = true) {
  const { queryKey, fetchPage } = useFetchCases(buildId, filter);
  return useQuery({
    queryKey: [...queryKey, 'page', 0],
    queryFn: ({ signal }) => fetchPage(0, signal),
    enabled,
    placeholderData: keepPreviousData,
    staleTime: Infinity,
  });
}

/** A case by its number; null if there is no such case. */
export function useCase(buildId: string, no: number | undefined) {
  const api = useApi();
  return useQuery({
    queryKey: [RESULTS, buildId, 'case', no],
    queryFn: async ({ signal }) => {
      const pageOf = (page: number, size: number) =>
        dataOf(
          api.GET('/api/v1/builds/{id}/result/cases', {
            params: { path: { id: buildId }, query: { page, size } },
            signal,
          }),
        );
      // The cases of a suite are numbered from 1, without gaps; a build of some cases has gaps.
      const own = (await pageOf((no ?? 1) - 1, 1)).items.find((item) => item.no === no);
      if (own) return own;
      const first = await pageOf(0, CASES_PER_PAGE);
      return first.items.find((item) => item.no === no) ?? null;
    },
    enabled: no !== undefined,
    staleTime: Infinity,
  });
}

const LIVE_REFRESH_MS = 1_000;

/** The finished cases of a build that has no result yet. */
export function useLiveCases(buildId: string, running: boolean) {
  const api = useApi();
  const cache = useQueryClient();
  const queryKey = [RESULTS, buildId, 'live'] as const;
  const fetchPage = (page: number, signal?: AbortSignal, size = CASES_PER_PAGE) =>
    dataOf(
      api.GET('/api/v1/builds/{id}/cases', {
        params: { path: { id: buildId }, query: { page, size } },
        ...(signal && { signal }),
      }),
    );
  const count = useQuery({
    queryKey: [...queryKey, 'count'],
    queryFn: async ({ signal }) => (await fetchPage(0, signal, 1)).total,
    refetchInterval: running ? LIVE_REFRESH_MS : false,
  });
  const total = count.data;
  const known = useRef(0);
  useEffect(() => {
    if (total === undefined || total === known.current) return;
    // Complete pages do not change. Fewer cases than before belong to a new attempt.
    const first = total < known.current ? 0 : Math.floor(known.current / CASES_PER_PAGE);
    known.current = total;
    void cache.invalidateQueries({
      queryKey: [RESULTS, buildId, 'live', 'page'],
      predicate: (query) => Number(query.queryKey.at(-1)) >= first,
    });
  }, [cache, buildId, total]);
  return { total, error: count.error, pages: { queryKey, fetchPage } };
}

/** The coverage of the component, by file. */
export function useCoverage(buildId: string) {
  const api = useApi();
  return useQuery({
    queryKey: [RESULTS, buildId, 'coverage'],
    queryFn: ({ signal }) =>
      dataOf(
        api.GET('/api/v1/builds/{id}/result/coverage', {
          params: { path: { id: buildId } },
          signal,
        }),
      ),
    staleTime: Infinity,
  });
}

/** The coverage of a source file, by line. */
export function useCoverageSource(buildId: string, path: string) {
  const api = useApi();
  return useQuery({
    queryKey: [RESULTS, buildId, 'coverage', path],
    queryFn: ({ signal }) =>
      dataOf(
        api.GET('/api/v1/builds/{id}/result/coverage/source', {
          params: { path: { id: buildId }, query: { path } },
          signal,
        }),
      ),
    staleTime: Infinity,
  });
}

export function useStatistics(buildId: string, enabled = true) {
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
    enabled,
    staleTime: Infinity,
  });
}
