import { keepPreviousData, useMutation, useQuery, useQueryClient } from '@tanstack/react-query';
import { dataOf, useApi, type Calendar, type ScheduleRequest } from '@/shared/api';

const SCHEDULES = ['schedules'] as const;
const CALENDARS = ['calendars'] as const;
const REFRESH_MS = 10_000;

export const SCHEDULES_PER_PAGE = 20;
export const FIRE_TIMES_PER_PAGE = 20;

/** The number of future times to show. */
export const NEXT_TIMES = 10;

/** A page of the schedules; pages count from 0. */
export function useSchedules(page: number) {
  const api = useApi();
  return useQuery({
    queryKey: [...SCHEDULES, 'page', page],
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

export function useSchedule(id: string) {
  const api = useApi();
  return useQuery({
    queryKey: [...SCHEDULES, 'one', id],
    queryFn: ({ signal }) =>
      dataOf(api.GET('/api/v1/schedules/{id}', { params: { path: { id } }, signal })),
    refetchInterval: REFRESH_MS,
  });
}

/** The next times of a schedule. */
export function useFireTimes(id: string) {
  const api = useApi();
  return useQuery({
    queryKey: [...SCHEDULES, 'one', id, 'times'],
    queryFn: ({ signal }) =>
      dataOf(
        api.GET('/api/v1/schedules/{id}/fire-times', {
          params: { path: { id }, query: { count: NEXT_TIMES } },
          signal,
        }),
      ),
    refetchInterval: REFRESH_MS,
  });
}

/** The next times of a schedule that is being edited. */
export function usePreview(request: ScheduleRequest | undefined) {
  const api = useApi();
  return useQuery({
    queryKey: [...SCHEDULES, 'preview', request],
    queryFn: ({ signal }) =>
      dataOf(
        api.POST('/api/v1/schedules/preview', {
          params: { query: { count: NEXT_TIMES } },
          body: request ?? {},
          signal,
        }),
      ),
    enabled: request !== undefined,
    placeholderData: keepPreviousData,
  });
}

/** The past times of a schedule with their builds, newest first. */
export function useScheduleHistory(id: string, page: number) {
  const api = useApi();
  return useQuery({
    queryKey: [...SCHEDULES, 'one', id, 'history', page],
    queryFn: ({ signal }) =>
      dataOf(
        api.GET('/api/v1/schedules/{id}/history', {
          params: { path: { id }, query: { page, size: FIRE_TIMES_PER_PAGE } },
          signal,
        }),
      ),
    placeholderData: keepPreviousData,
    refetchInterval: REFRESH_MS,
  });
}

export function useCreateSchedule() {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: (body: ScheduleRequest) => dataOf(api.POST('/api/v1/schedules', { body })),
    onSuccess: () => cache.invalidateQueries({ queryKey: SCHEDULES }),
  });
}

export type ScheduleAction = 'pause' | 'resume' | 'run' | 'delete';

/** Pauses, resumes, runs or deletes a schedule. */
export function useScheduleAction() {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: async ({ id, action }: { id: string; action: ScheduleAction }) => {
      const params = { params: { path: { id } } };
      switch (action) {
        case 'pause':
          await dataOf(api.POST('/api/v1/schedules/{id}/pause', params));
          return;
        case 'resume':
          await dataOf(api.POST('/api/v1/schedules/{id}/resume', params));
          return;
        case 'run':
          await dataOf(api.POST('/api/v1/schedules/{id}/run', params));
          return;
        case 'delete':
          await dataOf(api.DELETE('/api/v1/schedules/{id}', params));
      }
    },
    onSuccess: () => cache.invalidateQueries({ queryKey: SCHEDULES }),
  });
}

export function useCalendars() {
  const api = useApi();
  return useQuery({
    queryKey: CALENDARS,
    queryFn: ({ signal }) => dataOf(api.GET('/api/v1/calendars', { signal })),
  });
}

export function useSaveCalendar() {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: ({ name, ...body }: Calendar) =>
      dataOf(api.PUT('/api/v1/calendars/{name}', { params: { path: { name } }, body })),
    onSuccess: async () => {
      await cache.invalidateQueries({ queryKey: CALENDARS });
      await cache.invalidateQueries({ queryKey: SCHEDULES });
    },
  });
}

export function useDeleteCalendar() {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: (name: string) =>
      dataOf(api.DELETE('/api/v1/calendars/{name}', { params: { path: { name } } })),
    onSuccess: () => cache.invalidateQueries({ queryKey: CALENDARS }),
  });
}
