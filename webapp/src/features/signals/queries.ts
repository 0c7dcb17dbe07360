import { useQuery } from '@tanstack/react-query';
import { ApiError, dataOf, useApi } from '@/shared/api';

/** The signals of a case; null if there are none. */
export function useSignals(buildId: string, no: number) {
  const api = useApi();
  return useQuery({
    queryKey: ['signals', buildId, no],
    queryFn: async ({ signal }) => {
      try {
        return await dataOf(
          api.GET('/api/v1/builds/{id}/cases/{no}/signals', {
            params: { path: { id: buildId, no } },
            signal,
          }),
        );
      } catch (error) {
        if (error instanceof ApiError && error.status === 404) return null;
        throw error;
      }
    },
    enabled: Number.isSafeInteger(no) && no >= 1,
    retry: false,
    staleTime: Infinity,
  });
}
