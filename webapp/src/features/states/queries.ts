import { useQuery } from '@tanstack/react-query';
import { dataOf, useApi } from '@/shared/api';

/** The abstract states of a result of sequences. */
export function useStateDiagram(buildId: string, enabled = true) {
  const api = useApi();
  return useQuery({
    queryKey: ['states', buildId],
    queryFn: ({ signal }) =>
      dataOf(
        api.GET('/api/v1/builds/{id}/result/states', { params: { path: { id: buildId } }, signal }),
      ),
    enabled,
    // An accepted result never changes.
    staleTime: Infinity,
  });
}
