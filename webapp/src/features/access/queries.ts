import { useMutation, useQuery, useQueryClient } from '@tanstack/react-query';
import { dataOf, useApi } from '@/shared/api';

export const ROLES = ['VIEWER', 'TESTER', 'OPERATOR', 'ADMINISTRATOR'] as const;
export type Role = (typeof ROLES)[number];

/** Maximum number of listed items. Larger installations are administered by scripts. */
const LISTED = 200;

export function useUsers() {
  const api = useApi();
  return useQuery({
    queryKey: ['users'],
    queryFn: ({ signal }) =>
      dataOf(api.GET('/api/v1/users', { params: { query: { size: LISTED } }, signal })),
  });
}

export function useTokens() {
  const api = useApi();
  return useQuery({
    queryKey: ['tokens'],
    queryFn: ({ signal }) =>
      dataOf(api.GET('/api/v1/tokens', { params: { query: { size: LISTED } }, signal })),
  });
}

export function useAddUser() {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: (body: { name: string; role: Role }) => dataOf(api.POST('/api/v1/users', { body })),
    onSuccess: () => cache.invalidateQueries({ queryKey: ['users'] }),
  });
}

export function useChangeUser() {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: ({ id, ...body }: { id: string; role?: Role; enabled?: boolean }) =>
      dataOf(api.PATCH('/api/v1/users/{id}', { params: { path: { id } }, body })),
    onSuccess: () => cache.invalidateQueries({ queryKey: ['users'] }),
  });
}

export function useAddToken() {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: (body: { name: string; role: Role; days: number }) =>
      dataOf(api.POST('/api/v1/tokens', { body })),
    onSuccess: () => cache.invalidateQueries({ queryKey: ['tokens'] }),
  });
}

export function useRevokeToken() {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: (id: string) =>
      dataOf(api.DELETE('/api/v1/tokens/{id}', { params: { path: { id } } })),
    onSuccess: () => cache.invalidateQueries({ queryKey: ['tokens'] }),
  });
}
