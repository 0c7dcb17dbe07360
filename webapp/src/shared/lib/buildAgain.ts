import type { Build, BuildRequest } from '@/shared/api';

/** A request for another build of the same suite with the same options and cases. */
export function buildAgain(build: Build): BuildRequest {
  const { shards, cases } = build;
  return {
    ...options(build),
    ...(shards !== undefined && { shards }),
    ...(cases !== undefined && { cases }),
  };
}

/** A request for a build of the cases that did not pass, with the same options. */
export function buildFailedAgain(build: Build): BuildRequest {
  const { shards } = build;
  return { ...options(build), ...(shards !== undefined && { shards }), failedOf: build.id };
}

/** A request for a build of one case with the same options. */
export function buildCaseAgain(build: Build, no: number): BuildRequest {
  return { ...options(build), cases: String(no) };
}

/** All options except the cases and their shards. */
function options(build: Build): BuildRequest {
  const { suiteId, priority, retries, toolchain, labels, recordedCases, ros } = build;
  return {
    suiteId,
    recordings: recordedCases,
    ...(priority !== 0 && { priority }),
    ...(retries !== undefined && { retries }),
    ...(toolchain !== undefined && { toolchain }),
    ...(labels.length > 0 && { labels }),
    ...(ros === 'SYSTEM' && { ros }),
  };
}
