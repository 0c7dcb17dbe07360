import type { Build, BuildRequest } from '@/shared/api';

/** A request for another build of the same suite with the same options. */
export function buildAgain(build: Build): BuildRequest {
  const { suiteId, priority, shards, retries, toolchain, labels, recordedCases } = build;
  return {
    suiteId,
    recordings: recordedCases,
    ...(priority !== 0 && { priority }),
    ...(shards !== undefined && { shards }),
    ...(retries !== undefined && { retries }),
    ...(toolchain !== undefined && { toolchain }),
    ...(labels.length > 0 && { labels }),
  };
}
