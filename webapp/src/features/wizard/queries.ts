import { useMutation, useQuery, useQueryClient } from '@tanstack/react-query';
import { dataOf, useApi } from '@/shared/api';
import type { WizardDraft } from './draft';

const ZIP = { 'Content-Type': 'application/zip' };

/** The problems of a draft, reported by the server. */
export function useCheck(draft: WizardDraft, step: number) {
  const api = useApi();
  return useQuery({
    // Drafts are immutable, so their identity is the key.
    queryKey: ['wizard', 'check', step, identityOf(draft)],
    queryFn: async ({ signal }) => {
      const { archiveOf } = await import('./archive');
      const zip = new Blob([archiveOf(draft)]);
      return dataOf(
        api.POST('/api/v1/activity-checks', {
          body: zip as unknown as string,
          bodySerializer: () => zip,
          headers: ZIP,
          signal,
        }),
      );
    },
    gcTime: 0,
    placeholderData: (old) => old,
  });
}

let known = 0;
const identities = new WeakMap<WizardDraft, number>();

function identityOf(draft: WizardDraft): number {
  const identity = identities.get(draft) ?? ++known;
  identities.set(draft, identity);
  return identity;
}

export function useCreateActivity() {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: async (draft: WizardDraft) => {
      const { archiveOf } = await import('./archive');
      const zip = new Blob([archiveOf(draft)]);
      return dataOf(
        api.POST('/api/v1/activities', {
          body: zip as unknown as string,
          bodySerializer: () => zip,
          headers: ZIP,
        }),
      );
    },
    onSuccess: () => cache.invalidateQueries({ queryKey: ['activities'] }),
  });
}
