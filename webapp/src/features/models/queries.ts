import { useDebouncedValue } from '@mantine/hooks';
import { keepPreviousData, useMutation, useQuery, useQueryClient } from '@tanstack/react-query';
import { dataOf, useApi, type Activity } from '@/shared/api';

const XML = { 'Content-Type': 'application/xml' };
const DEBOUNCE_MS = 300;

export function useModelDocument(activityId: string, model: string) {
  const api = useApi();
  return useQuery({
    queryKey: ['models', activityId, model],
    queryFn: async ({ signal }) => {
      const answer = await api.GET('/api/v1/activities/{id}/models/{name}', {
        params: { path: { id: activityId, name: model } },
        parseAs: 'text',
        signal,
      });
      const document = await dataOf(Promise.resolve(answer));
      const etag = answer.response.headers.get('ETag') ?? '"0"';
      return { document: document, version: Number(etag.replaceAll('"', '')) };
    },
    // The document must not change while it is being edited.
    staleTime: Infinity,
    gcTime: 0,
  });
}

/** The values and cases of a draft, requested when typing pauses. */
export function usePreview(activityId: string, document: string, cases: boolean) {
  const api = useApi();
  const [debounced] = useDebouncedValue(document, DEBOUNCE_MS);
  return useQuery({
    queryKey: ['models', 'preview', activityId, debounced, cases],
    queryFn: ({ signal }) =>
      dataOf(
        api.POST('/api/v1/activities/{id}/model-previews', {
          params: { path: { id: activityId }, query: { cases } },
          body: debounced,
          bodySerializer: () => debounced,
          headers: XML,
          signal,
        }),
      ),
    enabled: debounced !== '',
    staleTime: Infinity,
    placeholderData: keepPreviousData,
  });
}

/** A first model of sequences for an interface of the activity. */
export function useSequenceProposal(activityId: string) {
  const api = useApi();
  return useMutation({
    mutationFn: ({ interfaceName, name }: { interfaceName: string; name: string }) =>
      dataOf(
        api.GET('/api/v1/activities/{id}/proposals/sequences', {
          params: { path: { id: activityId }, query: { interface: interfaceName, name } },
          parseAs: 'text',
        }),
      ),
  });
}

export interface SavedModel {
  name: string;
  document: string;
  version: number;
}

/** Replaces an existing model, or adds a new one to the activity and its profile. */
export function useSaveModel(activity: Activity, existing: string | undefined) {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: async ({ name, document, version }: SavedModel): Promise<Activity> => {
      const header = { 'If-Match': `"${version}"` };
      if (existing !== undefined) {
        return dataOf(
          api.PUT('/api/v1/activities/{id}/models/{name}', {
            params: { path: { id: activity.id, name: existing }, header },
            body: document,
            bodySerializer: () => document,
            headers: XML,
          }),
        );
      }
      const profile = await dataOf(
        api.GET('/api/v1/activities/{id}/files/{path}', {
          params: { path: { id: activity.id, path: 'activity.yaml' } },
          parseAs: 'text',
        }),
      );
      const path = `${name}.xml`;
      const { withModel } = await import('./profile');
      return dataOf(
        api.PATCH('/api/v1/activities/{id}/files', {
          params: { path: { id: activity.id }, header },
          body: {
            changes: [
              { path, content: document },
              { path: 'activity.yaml', content: withModel(profile, path) },
            ],
          },
        }),
      );
    },
    onSuccess: () =>
      Promise.all([
        cache.invalidateQueries({ queryKey: ['activities'] }),
        cache.invalidateQueries({ queryKey: ['models', activity.id] }),
      ]),
  });
}
