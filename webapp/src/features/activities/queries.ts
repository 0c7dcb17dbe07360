import { keepPreviousData, useMutation, useQuery, useQueryClient } from '@tanstack/react-query';
import { dataOf, useApi } from '@/shared/api';

const ACTIVITIES = ['activities'] as const;

/** Activities a page of the list holds. */
export const ACTIVITIES_PER_PAGE = 20;

/** A page of the activities; pages count from 0. */
export function useActivities(page: number) {
  const api = useApi();
  return useQuery({
    queryKey: [...ACTIVITIES, 'page', page],
    queryFn: ({ signal }) =>
      dataOf(
        api.GET('/api/v1/activities', {
          params: { query: { page, size: ACTIVITIES_PER_PAGE } },
          signal,
        }),
      ),
    placeholderData: keepPreviousData,
  });
}

export function useActivity(id: string) {
  const api = useApi();
  return useQuery({
    queryKey: [...ACTIVITIES, 'one', id],
    queryFn: ({ signal }) =>
      dataOf(api.GET('/api/v1/activities/{id}', { params: { path: { id } }, signal })),
  });
}

/** Creates an activity from a zip; the server verifies it before it keeps anything. */
export function useUploadActivity() {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: (zip: File) =>
      dataOf(
        api.POST('/api/v1/activities', {
          // The document knows a binary body only as a string.
          body: zip as unknown as string,
          bodySerializer: () => zip,
          headers: { 'Content-Type': 'application/zip' },
        }),
      ),
    onSuccess: () => cache.invalidateQueries({ queryKey: ACTIVITIES }),
  });
}
