import { useMutation, useQuery, useQueryClient } from '@tanstack/react-query';
import { dataOf, useApi, type WebhookEvent } from '@/shared/api';

/** The events, in the order in which they are shown. */
export const WEBHOOK_EVENTS = [
  'build.finished',
  'commit.started',
  'commit.finished',
] as const satisfies readonly WebhookEvent[];

/** Maximum number of listed items. Larger installations are administered by scripts. */
const LISTED = 200;

/** Milliseconds between two readings of the deliveries that are shown. */
const INTERVAL = 5_000;

/** Number of the deliveries that are shown, the latest ones. */
const DELIVERIES = 20;

export function useWebhooks() {
  const api = useApi();
  return useQuery({
    queryKey: ['webhooks'],
    queryFn: ({ signal }) =>
      dataOf(api.GET('/api/v1/webhooks', { params: { query: { size: LISTED } }, signal })),
  });
}

export function useAddWebhook() {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: (body: { url: string; activity?: string; events: WebhookEvent[] }) =>
      dataOf(api.POST('/api/v1/webhooks', { body })),
    onSuccess: () => cache.invalidateQueries({ queryKey: ['webhooks'] }),
  });
}

export function useDeleteWebhook() {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: (id: string) =>
      dataOf(api.DELETE('/api/v1/webhooks/{id}', { params: { path: { id } } })),
    onSuccess: () => cache.invalidateQueries({ queryKey: ['webhooks'], exact: true }),
  });
}

export function useDeliveries(id: string) {
  const api = useApi();
  return useQuery({
    queryKey: ['webhooks', id, 'deliveries'],
    queryFn: ({ signal }) =>
      dataOf(
        api.GET('/api/v1/webhooks/{id}/deliveries', {
          params: { path: { id }, query: { size: DELIVERIES } },
          signal,
        }),
      ),
    refetchInterval: INTERVAL,
  });
}
