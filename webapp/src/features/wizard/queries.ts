import { useMutation, useQuery, useQueryClient } from '@tanstack/react-query';
import { dataOf, useApi } from '@/shared/api';
import type { WizardDraft } from './draft';
import type { ProposalRequest } from './proposal';

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

/** The activity that the server proposes; nothing is stored. */
export function usePropose() {
  const api = useApi();
  return useMutation({
    mutationFn: async ({ files, query }: ProposalRequest) => {
      const { zipOf } = await import('./archive');
      const zip = new Blob([zipOf(files)]);
      return dataOf(
        api.POST('/api/v1/activity-proposals', {
          params: { query },
          body: zip as unknown as string,
          bodySerializer: () => zip,
          headers: ZIP,
        }),
      );
    },
  });
}

/** Creates an activity from the zip file of its files. */
export function useCreateActivity() {
  const api = useApi();
  const cache = useQueryClient();
  return useMutation({
    mutationFn: async (archive: () => Promise<Uint8Array<ArrayBuffer>>) => {
      const zip = new Blob([await archive()]);
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
