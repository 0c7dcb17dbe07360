import { useQuery } from '@tanstack/react-query';
import { dataOf, useApi } from '@/shared/api';

const HISTORY = 'history';

/** Results of an activity or of one of its models, newest first. */
export function useHistory(activityId: string, model?: string) {
  const api = useApi();
  return useQuery({
    queryKey: [HISTORY, activityId, model],
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
    queryKey: [HISTORY, 'comparison', buildId, other],
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
