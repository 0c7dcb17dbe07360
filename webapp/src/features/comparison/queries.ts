import { keepPreviousData, useQuery } from '@tanstack/react-query';
import { dataOf, useApi } from '@/shared/api';

const COMPARISON = 'comparison';
export const DIFFERENCES_PER_PAGE = 50;

/** The lists of a comparison besides its groups. */
export type Part = 'lastBits' | 'slower';

/** What two results do differently. Results never change. */
export function useValueComparison(buildId: string, other: string) {
  const api = useApi();
  return useQuery({
    queryKey: [COMPARISON, buildId, other],
    queryFn: ({ signal }) =>
      dataOf(
        api.GET('/api/v1/builds/{id}/result/comparison/values', {
          params: { path: { id: buildId }, query: { with: other } },
          signal,
        }),
      ),
    staleTime: Infinity,
  });
}

/** A page of the differences of a group, or of a list without groups. */
export function useDifferences(
  buildId: string,
  other: string,
  of: { group: number } | { part: Part },
  page: number,
) {
  const api = useApi();
  return useQuery({
    queryKey: [COMPARISON, buildId, other, of, page],
    queryFn: ({ signal }) =>
      dataOf(
        api.GET('/api/v1/builds/{id}/result/comparison/differences', {
          params: {
            path: { id: buildId },
            query: { with: other, page, size: DIFFERENCES_PER_PAGE, ...of },
          },
          signal,
        }),
      ),
    placeholderData: keepPreviousData,
    staleTime: Infinity,
  });
}

export function useNotComparable(buildId: string, other: string, page: number) {
  const api = useApi();
  return useQuery({
    queryKey: [COMPARISON, buildId, other, 'not comparable', page],
    queryFn: ({ signal }) =>
      dataOf(
        api.GET('/api/v1/builds/{id}/result/comparison/not-comparable', {
          params: {
            path: { id: buildId },
            query: { with: other, page, size: DIFFERENCES_PER_PAGE },
          },
          signal,
        }),
      ),
    placeholderData: keepPreviousData,
    staleTime: Infinity,
  });
}
