import { useMutation, useQuery, useQueryClient } from '@tanstack/react-query';
import { ApiError, dataOf, useApi } from '@/shared/api';

/** The signed-in user; null if no user is signed in. */
export function useSession() {
  const api = useApi();
  return useQuery({
    queryKey: ['session'],
    queryFn: async ({ signal }) => {
      try {
        return await dataOf(api.GET('/api/v1/session', { signal }));
      } catch (cause) {
        if (cause instanceof ApiError && cause.status === 401) return null;
        throw cause;
      }
    },
    staleTime: 60_000,
  });
}

export function useSignIn() {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: (body: { name: string; password: string }) =>
      dataOf(api.POST('/api/v1/session', { body })),
    // Requests that were refused before must be repeated.
    onSuccess: () => cache.resetQueries(),
  });
}

export function useSignOut() {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: () => dataOf(api.DELETE('/api/v1/session')),
    onSuccess: () => {
      cache.clear();
    },
  });
}
