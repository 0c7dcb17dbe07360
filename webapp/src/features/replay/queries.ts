import { keepPreviousData, useMutation, useQuery, useQueryClient } from '@tanstack/react-query';
import { ApiError, dataOf, useApi } from '@/shared/api';
import type { RecordedCases } from '@/shared/api';
import { readRecording } from './recording';

const RECORDINGS = 'recordings';

/** As many as a build of one agent can have. */
const MOST_LISTED = 500;
const LIVE_REFRESH_MS = 1_000;

/** What moved in a case; null where that was not recorded. */
export function useRecording(buildId: string, caseNo: number, sha256?: string) {
  const api = useApi();
  return useQuery({
    queryKey: [RECORDINGS, buildId, 'case', caseNo, sha256],
    queryFn: async ({ signal }) => {
      try {
        const glb = await dataOf(
          api.GET('/api/v1/builds/{id}/recordings/{caseNo}', {
            params: { path: { id: buildId, caseNo } },
            parseAs: 'arrayBuffer',
            signal,
          }),
        );
        return readRecording(glb);
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

/** Which cases of a build were recorded, by number. */
export function useRecordedCases(buildId: string) {
  const api = useApi();
  return useQuery({
    queryKey: [RECORDINGS, buildId, 'list'],
    queryFn: ({ signal }) =>
      dataOf(
        api.GET('/api/v1/builds/{id}/recordings', {
          params: { path: { id: buildId }, query: { size: MOST_LISTED } },
          signal,
        }),
      ),
  });
}

/** The recording that came last, looked for again and again while the build runs. */
export function useNewestRecording(buildId: string, running: boolean) {
  const api = useApi();
  return useQuery({
    // Asked once more when the build has ended: the last ones come with its end.
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

/** Asks for a build of the suite that records these cases. */
export function useRequestRecordedBuild(suiteId: string) {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: (recordings: RecordedCases) =>
      dataOf(api.POST('/api/v1/builds', { body: { suiteId, recordings } })),
    onSuccess: () => cache.invalidateQueries({ queryKey: ['builds'] }),
  });
}
