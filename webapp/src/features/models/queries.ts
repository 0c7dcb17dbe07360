import { useMutation, useQuery, useQueryClient } from '@tanstack/react-query';
import { useEffect, useState } from 'react';
import { dataOf, useApi, type Activity } from '@/shared/api';

const XML = { 'Content-Type': 'application/xml' };
const REST_MS = 300;

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
    // What is being edited is not to change under one's hands.
    staleTime: Infinity,
    gcTime: 0,
  });
}

/** What a draft gives, asked for when the hands rest. */
export function usePreview(activityId: string, document: string, cases: boolean) {
  const api = useApi();
  const rested = useRested(document);
  return useQuery({
    queryKey: ['models', 'preview', activityId, rested, cases],
    queryFn: ({ signal }) =>
      dataOf(
        api.POST('/api/v1/activities/{id}/model-previews', {
          params: { path: { id: activityId }, query: { cases } },
          body: rested,
          bodySerializer: () => rested,
          headers: XML,
          signal,
        }),
      ),
    enabled: rested !== '',
    staleTime: Infinity,
    placeholderData: (old) => old,
  });
}

function useRested(text: string): string {
  const [rested, setRested] = useState(text);
  useEffect(() => {
    const timer = setTimeout(() => {
      setRested(text);
    }, REST_MS);
    return () => {
      clearTimeout(timer);
    };
  }, [text]);
  return rested;
}

export interface SavedModel {
  name: string;
  document: string;
  version: number;
}

/** Puts a model in the place of the one it was, or adds it to the activity and its profile. */
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
