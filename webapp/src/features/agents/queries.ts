import { useQuery } from '@tanstack/react-query';
import { dataOf, useApi } from '@/shared/api';

const REFRESH_MS = 5_000;

export function useAgents() {
  const api = useApi();
  return useQuery({
    queryKey: ['agents'],
    queryFn: ({ signal }) => dataOf(api.GET('/api/v1/agents', { signal })),
    refetchInterval: REFRESH_MS,
  });
}
