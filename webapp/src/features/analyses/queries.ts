import { useMutation, useQuery, useQueryClient } from '@tanstack/react-query';
import { dataOf, useApi, type BuildAnalysis } from '@/shared/api';

const ANALYSES = 'analyses';
const REFRESH_MS = 1_000;

/** The analyses of a build, as in the paths of the REST interface. */
export type AnalysisKind = 'explanation' | 'score' | 'repetition';

/** The analyses that are requested without options. */
export type RequestedKind = Exclude<AnalysisKind, 'repetition'>;

const ENDED: readonly BuildAnalysis['state'][] = ['DONE', 'FAILED', 'CANCELLED'];

export function isEnded({ state }: BuildAnalysis): boolean {
  return ENDED.includes(state);
}

/** The latest analysis of a build; null if none was requested. */
export function useAnalysis(buildId: string, kind: AnalysisKind) {
  const api = useApi();
  return useQuery({
    queryKey: [ANALYSES, buildId, kind],
    queryFn: async ({ signal }) =>
      // Without a body, none was requested.
      (await dataOf(
        api.GET(`/api/v1/builds/{id}/${kind}`, { params: { path: { id: buildId } }, signal }),
      )) ?? null,
    refetchInterval: ({ state }) => (state.data && !isEnded(state.data) ? REFRESH_MS : false),
  });
}

/** Shows an analysis that was requested; its state is read again until it has ended. */
function useShowRequested(buildId: string, kind: AnalysisKind) {
  const cache = useQueryClient();
  return async (analysis: BuildAnalysis) => {
    const queryKey = [ANALYSES, buildId, kind];
    // An answer from before the request would replace the analysis, and end the reading.
    await cache.cancelQueries({ queryKey });
    cache.setQueryData(queryKey, analysis);
  };
}

/** Requests an explanation or a score. */
export function useRequestAnalysis(buildId: string, kind: RequestedKind) {
  const api = useApi();
  return useMutation({
    mutationFn: () =>
      dataOf(api.POST(`/api/v1/builds/{id}/${kind}`, { params: { path: { id: buildId } } })),
    onSuccess: useShowRequested(buildId, kind),
  });
}

/** Requests further runs of the cases of a build. */
export function useRepeatCases(buildId: string) {
  const api = useApi();
  return useMutation({
    mutationFn: (runs: number) =>
      dataOf(
        api.POST('/api/v1/builds/{id}/repetition', {
          params: { path: { id: buildId } },
          body: { runs },
        }),
      ),
    onSuccess: useShowRequested(buildId, 'repetition'),
  });
}

/** Cancels an analysis, which is a build of its own. */
export function useCancelAnalysis(buildId: string, kind: AnalysisKind) {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: (id: string) =>
      dataOf(api.POST('/api/v1/builds/{id}/cancel', { params: { path: { id } } })),
    onSettled: () => cache.invalidateQueries({ queryKey: [ANALYSES, buildId, kind] }),
  });
}

/** Requests a build of the simplest case of a cause; causes count from 1. */
export function useRunSimplest(buildId: string) {
  const api = useApi();
  return useMutation({
    mutationFn: (no: number) =>
      dataOf(
        api.POST('/api/v1/builds/{id}/explanation/causes/{no}/run', {
          params: { path: { id: buildId, no } },
        }),
      ),
  });
}
