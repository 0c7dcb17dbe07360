import { useMutation, useQuery, useQueryClient } from '@tanstack/react-query';
import { dataOf, useApi, type Agent } from '@/shared/api';

const REFRESH_MS = 5_000;
const AGENTS = ['agents'] as const;
const ENROLMENTS = ['enrolments'] as const;

/** Maximum number of listed items. Larger installations are administered by scripts. */
const LISTED = 200;

export function useAgents() {
  const api = useApi();
  return useQuery({
    queryKey: AGENTS,
    queryFn: ({ signal }) => dataOf(api.GET('/api/v1/agents', { signal })),
    refetchInterval: REFRESH_MS,
  });
}

/** The labels of all agents, without duplicates. */
export function useOffersOfAgents(): { labels: string[]; offersRos: boolean } {
  const agents = useAgents().data ?? [];
  return {
    labels: [...new Set(agents.flatMap(({ labels }) => labels))].sort(),
    offersRos: agents.some(({ toolchains }) =>
      toolchains.some(({ language }) => language === 'ros'),
    ),
  };
}

/** Activates, drains or disables an agent. */
export function useSetAgentState() {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: ({ name, standing }: { name: string; standing: Agent['standing'] }) =>
      dataOf(
        api.PUT('/api/v1/agents/{name}/standing', {
          params: { path: { name } },
          body: { standing },
        }),
      ),
    onSuccess: () => cache.invalidateQueries({ queryKey: AGENTS }),
  });
}

export function useRemoveAgent() {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: (name: string) =>
      dataOf(api.DELETE('/api/v1/agents/{name}', { params: { path: { name } } })),
    onSuccess: () => cache.invalidateQueries({ queryKey: AGENTS }),
  });
}

export function useEnrolments() {
  const api = useApi();
  return useQuery({
    queryKey: ENROLMENTS,
    queryFn: ({ signal }) =>
      dataOf(api.GET('/api/v1/enrolments', { params: { query: { size: LISTED } }, signal })),
  });
}

export function useEnrol() {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: (body: { agent?: string; uses: number; hours: number }) =>
      dataOf(api.POST('/api/v1/enrolments', { body })),
    onSuccess: () => cache.invalidateQueries({ queryKey: ENROLMENTS }),
  });
}

export function useDeleteEnrolment() {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: (id: string) =>
      dataOf(api.DELETE('/api/v1/enrolments/{id}', { params: { path: { id } } })),
    onSuccess: () => cache.invalidateQueries({ queryKey: ENROLMENTS }),
  });
}
