import type { BuildRequest } from '@/shared/api';
import type { RecordingsWish } from '@/shared/lib/recordings';

/** How a build is executed, beyond what its files need anyway; as it is typed. */
export interface BuildOptions {
  priority: string;
  shards: string;
  retries: string;
  toolchain: string;
  labels: string[];
  recordings: RecordingsWish;
}

export const DEFAULT_OPTIONS: BuildOptions = {
  priority: '0',
  shards: '1',
  retries: '',
  toolchain: '',
  labels: [],
  recordings: '',
};

/** As the server is asked; what is as ever is left out. */
export function requestOf(options: BuildOptions): Omit<BuildRequest, 'suiteId'> {
  const { priority, shards, retries, toolchain, labels, recordings } = options;
  return {
    ...(Number(priority) !== 0 && { priority: Number(priority) }),
    ...(Number(shards) > 1 && { shards: Number(shards) }),
    ...(retries.trim() !== '' && { retries: Number(retries) }),
    ...(toolchain.trim() !== '' && { toolchain: toolchain.trim() }),
    ...(labels.length > 0 && { labels }),
    ...(recordings !== '' && { recordings }),
  };
}

const RECORDED: Record<Exclude<RecordingsWish, ''>, string> = {
  ALL: 'all cases recorded',
  FAILED: 'failing cases recorded',
  NONE: 'nothing recorded',
};

/** In a few words; empty where all is as ever. */
export function inWords(options: BuildOptions): string {
  const { priority, shards, retries, toolchain, labels, recordings } = options;
  return [
    Number(priority) !== 0 && `priority ${priority}`,
    Number(shards) > 1 && `${shards} shards`,
    retries.trim() !== '' && `${retries} retries`,
    toolchain.trim() !== '' && `toolchain ${toolchain.trim()}`,
    labels.length > 0 && `labels ${labels.join(', ')}`,
    recordings !== '' && RECORDED[recordings],
  ]
    .filter(Boolean)
    .join(', ');
}
