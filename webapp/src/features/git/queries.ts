import { keepPreviousData, useMutation, useQuery, useQueryClient } from '@tanstack/react-query';
import { ApiError, dataOf, useApi, type GitRequest, type GitSourceRequest } from '@/shared/api';

const GIT = ['git'] as const;

/** Page size of the list of commits. */
export const COMMITS_PER_PAGE = 30;

/** Page size of the list of pull or merge requests. */
export const REQUESTS_PER_PAGE = 20;

/** The searches for first bad commits that are shown. */
const SEARCHES = 10;

export type GitRequestState = GitRequest['state'];

/** Milliseconds between two looks at commits whose builds run. */
const REFRESH_MS = 3000;

/** The Git source of an activity; null if it has none. */
export function useGitSource(activityId: string) {
  const api = useApi();
  return useQuery({
    queryKey: [...GIT, activityId, 'source'],
    queryFn: async ({ signal }) => {
      try {
        return await dataOf(
          api.GET('/api/v1/activities/{id}/git', { params: { path: { id: activityId } }, signal }),
        );
      } catch (error) {
        if (error instanceof ApiError && error.status === 404) return null;
        throw error;
      }
    },
    refetchInterval: REFRESH_MS,
  });
}

/**
 * A page of the commits of the branch, or of a pull or merge request, the newest first; pages
 * count from 0.
 */
export function useGitCommits(activityId: string, request: number | undefined, page: number) {
  const api = useApi();
  return useQuery({
    queryKey: [...GIT, activityId, 'commits', request, page],
    queryFn: ({ signal }) =>
      dataOf(
        api.GET('/api/v1/activities/{id}/git/commits', {
          params: {
            path: { id: activityId },
            query: { ...(request !== undefined && { request }), page, size: COMMITS_PER_PAGE },
          },
          signal,
        }),
      ),
    placeholderData: keepPreviousData,
    refetchInterval: REFRESH_MS,
  });
}

/** A page of the pull or merge requests, the highest number first; pages count from 0. */
export function useGitRequests(
  activityId: string,
  state: GitRequestState | undefined,
  page: number,
) {
  const api = useApi();
  return useQuery({
    queryKey: [...GIT, activityId, 'requests', state, page],
    queryFn: ({ signal }) =>
      dataOf(
        api.GET('/api/v1/activities/{id}/git/requests', {
          params: {
            path: { id: activityId },
            query: { ...(state && { state }), page, size: REQUESTS_PER_PAGE },
          },
          signal,
        }),
      ),
    placeholderData: keepPreviousData,
    refetchInterval: REFRESH_MS,
  });
}

/** Fetches and builds the head of a request that the user has seen. */
export function useBuildGitRequest(activityId: string) {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: ({ number, head }: { number: number; head: string }) =>
      dataOf(
        api.POST('/api/v1/activities/{id}/git/requests/{number}/build', {
          params: { path: { id: activityId, number } },
          body: { head },
        }),
      ),
    onSettled: () => cache.invalidateQueries({ queryKey: [...GIT, activityId] }),
  });
}

/** The newest searches for first bad commits of the branch. */
export function useGitBisections(activityId: string) {
  const api = useApi();
  return useQuery({
    queryKey: [...GIT, activityId, 'bisections'],
    queryFn: ({ signal }) =>
      dataOf(
        api.GET('/api/v1/activities/{id}/git/bisections', {
          params: { path: { id: activityId }, query: { page: 0, size: SEARCHES } },
          signal,
        }),
      ),
    refetchInterval: REFRESH_MS,
  });
}

/** Searches the first bad commit up to a commit of the branch. */
export function useBeginGitBisection(activityId: string) {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: (commit: string) =>
      dataOf(
        api.POST('/api/v1/activities/{id}/git/bisections', {
          params: { path: { id: activityId } },
          body: { commit },
        }),
      ),
    onSettled: () => cache.invalidateQueries({ queryKey: [...GIT, activityId] }),
  });
}

export function useCancelGitBisection(activityId: string) {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: (number: number) =>
      dataOf(
        api.POST('/api/v1/activities/{id}/git/bisections/{number}/cancel', {
          params: { path: { id: activityId, number } },
        }),
      ),
    onSettled: () => cache.invalidateQueries({ queryKey: [...GIT, activityId] }),
  });
}

export function useSaveGitSource(activityId: string) {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: ({ version, ...body }: GitSourceRequest & { version: number | undefined }) =>
      dataOf(
        api.PUT('/api/v1/activities/{id}/git', {
          params: {
            path: { id: activityId },
            header: { 'If-Match': version === undefined ? '*' : `"${version}"` },
          },
          body,
        }),
      ),
    onSuccess: () => cache.invalidateQueries({ queryKey: [...GIT, activityId] }),
  });
}

export function useDeleteGitSource(activityId: string) {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: () =>
      dataOf(api.DELETE('/api/v1/activities/{id}/git', { params: { path: { id: activityId } } })),
    onSuccess: () => cache.invalidateQueries({ queryKey: [...GIT, activityId] }),
  });
}

export function useFetchGitSource(activityId: string) {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: () =>
      dataOf(
        api.POST('/api/v1/activities/{id}/git/fetch', { params: { path: { id: activityId } } }),
      ),
    onSuccess: () => cache.invalidateQueries({ queryKey: [...GIT, activityId] }),
  });
}

/** Creates the secret with which the forge signs its messages. */
export function useCreateGitHook(activityId: string) {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: () =>
      dataOf(
        api.POST('/api/v1/activities/{id}/git/hook', { params: { path: { id: activityId } } }),
      ),
    onSuccess: () => cache.invalidateQueries({ queryKey: [...GIT, activityId] }),
  });
}

/** Creates an activity from a folder of a branch. */
export function useCreateFromGit() {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: (body: GitSourceRequest) => dataOf(api.POST('/api/v1/git-activities', { body })),
    onSuccess: () => cache.invalidateQueries({ queryKey: ['activities'] }),
  });
}
