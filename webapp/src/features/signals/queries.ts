import { useQuery } from '@tanstack/react-query';
import { dataOf, useApi } from '@/shared/api';

/** The signals of a case; null if there are none. */
export function useSignals(buildId: string, no: number) {
  const api = useApi();
  return useQuery({
    queryKey: ['signals', buildId, no],
    queryFn: async ({ signal }) =>
      // Without a body, no signals are stored.
      (await dataOf(
        api.GET('/api/v1/builds/{id}/cases/{no}/signals', {
          params: { path: { id: buildId, no } },
          signal,
        }),
      )) ?? null,
    enabled: Number.isSafeInteger(no) && no >= 1,
    retry: false,
    staleTime: Infinity,
  });
}
