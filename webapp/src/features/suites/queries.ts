import { useMutation, useQuery, useQueryClient } from '@tanstack/react-query';
import { dataOf, useApi, type Suite, type SuiteOptions } from '@/shared/api';

const SUITES = 'suites';

/** Cases that are fetched at once: a suite of 100,000 is never loaded whole. */
export const CASES_PER_PAGE = 200;

/** The test model a suite is generated from; options left out are the model's own. */
export interface SuiteOf {
  activityId: string;
  model: string;
  options?: SuiteOptions;
}

/** Generates and keeps a suite of test cases. */
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
        // Somebody else changed it: the cases in sight are old.
        void cache.invalidateQueries({ queryKey: [SUITES, 'cases', id] });
      }
      return suite;
    },
  });
}

/** Suites of an activity, the newest first. */
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

/** Pages of a suite's cases. */
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
  /** Absent: nothing is expected. */
  literal?: string;
}

export interface Fill {
  output?: string;
  expression: string;
  onlyEmpty: boolean;
}

/** A change of a suite, onto the version that its author saw. */
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
      // Before what was typed gives way to what is stored, that must be here.
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

/** The sources of the test application; `activityVersion` keeps them apart from older ones. */
export function useHarness(id: string, activityVersion: number) {
  const api = useApi();
  return useQuery({
    queryKey: [SUITES, 'harness', id, activityVersion],
    queryFn: ({ signal }) =>
      dataOf(api.GET('/api/v1/suites/{id}/harness', { params: { path: { id } }, signal })),
  });
}
