import { keepPreviousData, useMutation, useQuery, useQueryClient } from '@tanstack/react-query';
import { dataOf, useApi } from '@/shared/api';

const ACTIVITIES = ['activities'] as const;

/** Page size of the list. */
export const ACTIVITIES_PER_PAGE = 20;

/** A page of the activities, of all or of those with a text and a tag; pages count from 0. */
export function useActivities(page: number, search?: string, tag?: string) {
  const api = useApi();
  return useQuery({
    queryKey: [...ACTIVITIES, 'page', page, search, tag],
    queryFn: ({ signal }) =>
      dataOf(
        api.GET('/api/v1/activities', {
          params: {
            query: {
              page,
              size: ACTIVITIES_PER_PAGE,
              ...(search && { search }),
              ...(tag && { tag: [tag] }),
            },
          },
          signal,
        }),
      ),
    placeholderData: keepPreviousData,
  });
}

/** The tags of all activities, with the number of activities of each. */
export function useTags() {
  const api = useApi();
  return useQuery({
    queryKey: [...ACTIVITIES, 'tags'],
    queryFn: ({ signal }) => dataOf(api.GET('/api/v1/tags', { signal })),
  });
}

/** Replaces the tags of an activity. */
export function useReplaceTags(id: string) {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: (tags: string[]) =>
      dataOf(api.PUT('/api/v1/activities/{id}/tags', { params: { path: { id } }, body: { tags } })),
    onSuccess: () => cache.invalidateQueries({ queryKey: ACTIVITIES }),
  });
}

/** The newest activities, for a selection. */
export function useActivityChoice() {
  const api = useApi();
  return useQuery({
    queryKey: [...ACTIVITIES, 'choice'],
    queryFn: ({ signal }) =>
      dataOf(api.GET('/api/v1/activities', { params: { query: { page: 0, size: 200 } }, signal })),
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

/** The interfaces and the world of an activity. */
export function useDescription(id: string) {
  const api = useApi();
  return useQuery({
    queryKey: [...ACTIVITIES, 'one', id, 'description'],
    queryFn: ({ signal }) =>
      dataOf(api.GET('/api/v1/activities/{id}/description', { params: { path: { id } }, signal })),
  });
}

/** The text of a file. `sha256` distinguishes its versions in the cache. */
export function useFileText(id: string, path: string, sha256: string) {
  const api = useApi();
  return useQuery({
    queryKey: [...ACTIVITIES, 'one', id, 'file', path, sha256],
    queryFn: async ({ signal }) => {
      // The client would encode the slashes of the path.
      const address = path.split('/').map(encodeURIComponent).join('/');
      const bytes = await dataOf(
        api.GET('/api/v1/activities/{id}/files/{path}', {
          params: { path: { id, path: address } },
          pathSerializer: (template) =>
            template.replace('{id}', () => encodeURIComponent(id)).replace('{path}', () => address),
          parseAs: 'arrayBuffer',
          signal,
        }),
      );
      return new TextDecoder().decode(bytes);
    },
    staleTime: Infinity,
  });
}

export interface FileChange {
  path: string;
  /** Absent: the file is removed. */
  content?: string;
}

/** Changes files of an activity if it still has the given version. */
export function useChangeFiles(id: string) {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: ({ changes, version }: { changes: FileChange[]; version: number }) =>
      dataOf(
        api.PATCH('/api/v1/activities/{id}/files', {
          params: { path: { id }, header: { 'If-Match': `"${version}"` } },
          body: { changes },
        }),
      ),
    onSuccess: () => cache.invalidateQueries({ queryKey: ACTIVITIES }),
  });
}

/** Adds files to an activity if it still has the given version; those of the same paths are replaced. */
export function useAddFiles(id: string) {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: async ({ files, version }: { files: readonly AddedFile[]; version: number }) => {
      const { zipSync } = await import('fflate');
      const contents = await Promise.all(
        files.map(async ({ path, file }) => [path, new Uint8Array(await file.arrayBuffer())]),
      );
      const zip = new Blob([zipSync(Object.fromEntries(contents) as Record<string, Uint8Array>)]);
      return dataOf(
        api.POST('/api/v1/activities/{id}/files', {
          params: { path: { id }, header: { 'If-Match': `"${version}"` } },
          body: zip as unknown as string,
          bodySerializer: () => zip,
          headers: { 'Content-Type': 'application/zip' },
        }),
      );
    },
    onSuccess: () => cache.invalidateQueries({ queryKey: ACTIVITIES }),
  });
}

export interface AddedFile {
  /** In the activity. */
  path: string;
  file: File;
}

/** Creates an activity from a zip file, which the server checks first. */
export function useUploadActivity() {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: (zip: File) =>
      dataOf(
        api.POST('/api/v1/activities', {
          // OpenAPI declares a binary body as a string.
          body: zip as unknown as string,
          bodySerializer: () => zip,
          headers: { 'Content-Type': 'application/zip' },
        }),
      ),
    onSuccess: () => cache.invalidateQueries({ queryKey: ACTIVITIES }),
  });
}
