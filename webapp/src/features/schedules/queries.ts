import { keepPreviousData, useMutation, useQuery, useQueryClient } from '@tanstack/react-query';
import { dataOf, useApi } from '@/shared/api';

const SCHEDULES = ['schedules'] as const;
const REFRESH_MS = 10_000;

export const SCHEDULES_PER_PAGE = 20;

/** A page of the schedules; pages count from 0. */
export function useSchedules(page: number) {
  const api = useApi();
  return useQuery({
    queryKey: [...SCHEDULES, page],
    queryFn: ({ signal }) =>
      dataOf(
        api.GET('/api/v1/schedules', {
          params: { query: { page, size: SCHEDULES_PER_PAGE } },
          signal,
        }),
      ),
    placeholderData: keepPreviousData,
    refetchInterval: REFRESH_MS,
  });
}

/** Reserves a build; `at` is a date and time with its zone. */
export function useReserveBuild() {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: (body: { suiteId: string; at: string }) =>
      dataOf(api.POST('/api/v1/schedules', { body })),
    onSuccess: () => cache.invalidateQueries({ queryKey: SCHEDULES }),
  });
}

export function useDeleteSchedule() {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: (id: string) =>
      dataOf(api.DELETE('/api/v1/schedules/{id}', { params: { path: { id } } })),
    onSuccess: () => cache.invalidateQueries({ queryKey: SCHEDULES }),
  });
}
