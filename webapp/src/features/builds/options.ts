import type { BuildRequest } from '@/shared/api';

/** How a build is executed, beyond what its files need anyway; as it is typed. */
export interface BuildOptions {
  priority: string;
  shards: string;
  retries: string;
  toolchain: string;
  labels: string[];
}

export const DEFAULT_OPTIONS: BuildOptions = {
  priority: '0',
  shards: '1',
  retries: '',
  toolchain: '',
  labels: [],
};

/** As the server is asked; what is as ever is left out. */
export function requestOf(options: BuildOptions): Omit<BuildRequest, 'suiteId'> {
  const { priority, shards, retries, toolchain, labels } = options;
  return {
    ...(Number(priority) !== 0 && { priority: Number(priority) }),
    ...(Number(shards) > 1 && { shards: Number(shards) }),
    ...(retries.trim() !== '' && { retries: Number(retries) }),
    ...(toolchain.trim() !== '' && { toolchain: toolchain.trim() }),
    ...(labels.length > 0 && { labels }),
  };
}

/** In a few words; empty where all is as ever. */
export function inWords({ priority, shards, retries, toolchain, labels }: BuildOptions): string {
  return [
    Number(priority) !== 0 && `priority ${priority}`,
    Number(shards) > 1 && `${shards} shards`,
    retries.trim() !== '' && `${retries} retries`,
    toolchain.trim() !== '' && `toolchain ${toolchain.trim()}`,
    labels.length > 0 && `labels ${labels.join(', ')}`,
  ]
    .filter(Boolean)
    .join(', ');
}
