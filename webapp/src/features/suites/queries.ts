import { useMutation, useQuery, useQueryClient } from '@tanstack/react-query';
import { dataOf, useApi, type Suite, type SuiteOptions } from '@/shared/api';

const SUITES = 'suites';

/** Page size: large suites are loaded page by page. */
export const CASES_PER_PAGE = 200;

/** The test model of a new suite. Missing options default to those of the model. */
export interface SuiteOf {
  activityId: string;
  model: string;
  options?: SuiteOptions;
}

/** Generates and stores a suite of test cases. */
export function useGenerateSuite() {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: ({ activityId, model, options = {} }: SuiteOf) =>
      dataOf(
        api.POST('/api/v1/activities/{id}/models/{name}/suites', {
          params: { path: { id: activityId, name: model } },
          body: options,
        }),
      ),
    onSuccess: () => cache.invalidateQueries({ queryKey: [SUITES, 'list'] }),
  });
}

export function useSuite(id: string) {
  const api = useApi();
  const cache = useQueryClient();
  const queryKey = [SUITES, 'one', id];
  return useQuery({
    queryKey,
    queryFn: async ({ signal }) => {
      const suite = await dataOf(
        api.GET('/api/v1/suites/{id}', { params: { path: { id } }, signal }),
      );
      const known = cache.getQueryData<Suite>(queryKey);
      if (known && known.version !== suite.version) {
        // Another user changed the suite: the loaded cases are outdated.
        void cache.invalidateQueries({ queryKey: [SUITES, 'cases', id] });
      }
      return suite;
    },
  });
}

/** Suites of an activity, newest first. */
export function useSuites(activityId: string) {
  const api = useApi();
  return useQuery({
    queryKey: [SUITES, 'list', activityId],
    queryFn: ({ signal }) =>
      dataOf(
        api.GET('/api/v1/activities/{id}/suites', {
          params: { path: { id: activityId }, query: { size: 20 } },
          signal,
        }),
      ),
  });
}

/** The cases of a suite, page by page. */
export function useFetchCases(id: string) {
  const api = useApi();
  return {
    queryKey: [SUITES, 'cases', id] as const,
    fetchPage: (page: number, signal?: AbortSignal) =>
      dataOf(
        api.GET('/api/v1/suites/{id}/cases', {
          params: { path: { id }, query: { page, size: CASES_PER_PAGE } },
          ...(signal && { signal }),
        }),
      ),
  };
}

export interface ExpectedChange {
  no: number;
  output?: string;
  /** Absent to remove the expected value. */
  literal?: string;
}

export interface Fill {
  output?: string;
  expression: string;
  onlyEmpty: boolean;
}

/** A change of a suite. */
export type SuiteChange =
  | { kind: 'expected'; changes: ExpectedChange[] }
  | ({ kind: 'fill' } & Fill)
  | { kind: 'undo' }
  | { kind: 'import'; format: ImportFormat; text: string };

export type ImportFormat = 'csv' | 'json' | 'xml';

export function useChangeSuite(id: string) {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: ({ change, version }: { change: SuiteChange; version: number }): Promise<Suite> => {
      const params = { path: { id }, header: { 'If-Match': `"${version}"` } };
      switch (change.kind) {
        case 'expected':
          return dataOf(
            api.PATCH('/api/v1/suites/{id}/expected', {
              params,
              body: { changes: change.changes },
            }),
          );
        case 'fill': {
          const { output, expression, onlyEmpty } = change;
          const body = { expression, onlyEmpty, ...(output !== undefined && { output }) };
          return dataOf(api.POST('/api/v1/suites/{id}/expected/fill', { params, body }));
        }
        case 'undo':
          return dataOf(api.POST('/api/v1/suites/{id}/undo', { params }));
        case 'import': {
          const { text } = change;
          const raw = { params, body: text, bodySerializer: () => text };
          switch (change.format) {
            case 'csv':
              return dataOf(
                api.PUT('/api/v1/suites/{id}/cases.csv', {
                  ...raw,
                  headers: { 'Content-Type': 'text/csv' },
                }),
              );
            case 'json':
              return dataOf(
                api.PUT('/api/v1/suites/{id}/cases.json', {
                  ...raw,
                  headers: { 'Content-Type': 'application/octet-stream' },
                }),
              );
            case 'xml':
              return dataOf(
                api.PUT('/api/v1/suites/{id}/document', {
                  ...raw,
                  headers: { 'Content-Type': 'application/xml' },
                }),
              );
          }
        }
      }
    },
    onSuccess: async (suite) => {
      cache.setQueryData([SUITES, 'one', id], suite);
      // The stored cases must be loaded before the unsaved values are dropped.
      await cache.invalidateQueries({ queryKey: [SUITES, 'cases', id] });
    },
  });
}

export function useCombinations(id: string, version: number, pair?: [number, number]) {
  const api = useApi();
  return useQuery({
    queryKey: [SUITES, 'combinations', id, version, pair],
    queryFn: ({ signal }) =>
      dataOf(
        api.GET('/api/v1/suites/{id}/combinations', {
          params: { path: { id }, query: pair ? { first: pair[0], second: pair[1] } : {} },
          signal,
        }),
      ),
    staleTime: Infinity,
    placeholderData: (old) => old,
  });
}

export function useSuiteChanges(id: string, version: number) {
  const api = useApi();
  return useQuery({
    queryKey: [SUITES, 'changes', id, version],
    queryFn: ({ signal }) =>
      dataOf(api.GET('/api/v1/suites/{id}/changes', { params: { path: { id } }, signal })),
  });
}

/** The sources of the test application. `activityVersion` distinguishes them in the cache. */
export function useHarness(id: string, activityVersion: number) {
  const api = useApi();
  return useQuery({
    queryKey: [SUITES, 'harness', id, activityVersion],
    queryFn: ({ signal }) =>
      dataOf(api.GET('/api/v1/suites/{id}/harness', { params: { path: { id } }, signal })),
  });
}
