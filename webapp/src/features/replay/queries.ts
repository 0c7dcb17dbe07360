import { keepPreviousData, useMutation, useQuery, useQueryClient } from '@tanstack/react-query';
import { ApiError, dataOf, useApi } from '@/shared/api';
import type { Build, RecordedCases } from '@/shared/api';
import { buildAgain } from '@/shared/lib/buildAgain';
import { readRecording } from './recording';

const RECORDINGS = 'recordings';

/** Maximum number of recordings of a build. */
const MAX_LISTED = 500;
const LIVE_REFRESH_MS = 1_000;

interface RecordingOptions {
  /** The content that the list of recordings names. */
  sha256?: string;
  /** The place of a relation in the model, from 1, for the second run of the case. */
  relation?: number | undefined;
}

/** The recording of a case; null if there is none. */
export function useRecording(
  buildId: string,
  caseNo: number,
  { sha256, relation }: RecordingOptions = {},
) {
  const api = useApi();
  return useQuery({
    queryKey: [RECORDINGS, buildId, 'case', caseNo, relation, sha256],
    queryFn: async ({ signal }) => {
      const options = { parseAs: 'arrayBuffer', signal } as const;
      try {
        return readRecording(
          relation === undefined
            ? await dataOf(
                api.GET('/api/v1/builds/{id}/recordings/{caseNo}', {
                  params: { path: { id: buildId, caseNo } },
                  ...options,
                }),
              )
            : await dataOf(
                api.GET('/api/v1/builds/{id}/recordings/{caseNo}/relations/{relation}', {
                  params: { path: { id: buildId, caseNo, relation } },
                  ...options,
                }),
              ),
        );
      } catch (error) {
        if (error instanceof ApiError && error.status === 404) return null;
        throw error;
      }
    },
    placeholderData: keepPreviousData,
    retry: false,
    staleTime: Infinity,
  });
}

/** The recorded cases of a build, by number. */
export function useRecordedCases(buildId: string) {
  const api = useApi();
  return useQuery({
    queryKey: [RECORDINGS, buildId, 'list'],
    queryFn: ({ signal }) =>
      dataOf(
        api.GET('/api/v1/builds/{id}/recordings', {
          params: { path: { id: buildId }, query: { size: MAX_LISTED } },
          signal,
        }),
      ),
  });
}

/** The newest recording; updated while the build runs. */
export function useNewestRecording(buildId: string, running: boolean) {
  const api = useApi();
  return useQuery({
    // `running` repeats the request when the build ends, because its last recordings arrive then.
    queryKey: [RECORDINGS, buildId, 'newest', running],
    queryFn: async ({ signal }) => {
      const { items, total } = await dataOf(
        api.GET('/api/v1/builds/{id}/recordings', {
          params: { path: { id: buildId }, query: { order: 'NEWEST', size: 1 } },
          signal,
        }),
      );
      return { newest: items[0] ?? null, total };
    },
    placeholderData: keepPreviousData,
    refetchInterval: running ? LIVE_REFRESH_MS : false,
  });
}

/** Requests another build with other recordings. */
export function useRequestRecordedBuild(build: Build) {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: (recordings: RecordedCases) =>
      dataOf(api.POST('/api/v1/builds', { body: { ...buildAgain(build), recordings } })),
    onSuccess: () => cache.invalidateQueries({ queryKey: ['builds'] }),
  });
}
