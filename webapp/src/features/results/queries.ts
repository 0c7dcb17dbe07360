import { keepPreviousData, useQuery } from '@tanstack/react-query';
import { dataOf, useApi, type Verdict } from '@/shared/api';

/** Cases a page of the table holds: a suite of 100,000 is never loaded at once. */
export const CASES_PER_PAGE = 100;

export function useResult(buildId: string) {
  const api = useApi();
  return useQuery({
    queryKey: ['results', buildId],
    queryFn: ({ signal }) =>
      dataOf(api.GET('/api/v1/builds/{id}/result', { params: { path: { id: buildId } }, signal })),
    // An accepted result never changes.
    staleTime: Infinity,
  });
}

/** A page of a result's cases, of one verdict or of all; pages count from 0. */
export function useResultCases(buildId: string, page: number, verdict?: Verdict) {
  const api = useApi();
  return useQuery({
    queryKey: ['results', buildId, 'cases', page, verdict],
    queryFn: ({ signal }) =>
      dataOf(
        api.GET('/api/v1/builds/{id}/result/cases', {
          params: {
            path: { id: buildId },
            query: { page, size: CASES_PER_PAGE, ...(verdict && { verdict }) },
          },
          signal,
        }),
      ),
    placeholderData: keepPreviousData,
    staleTime: Infinity,
  });
}
