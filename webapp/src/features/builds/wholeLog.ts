import type { ApiClient } from '@/shared/api';

/** The whole log of a build. The server answers with at most 1 MiB for each request. */
export async function wholeLog(api: ApiClient, buildId: string): Promise<Blob> {
  const parts: ArrayBuffer[] = [];
  let offset = 0;
  for (;;) {
    const { bytes, end } = await readLog(api, buildId, offset);
    parts.push(bytes);
    offset += bytes.byteLength;
    if (bytes.byteLength === 0 || offset >= end) return new Blob(parts, { type: 'text/plain' });
  }
}

/** A part of a log from an offset in bytes, and the present length of the log in bytes. */
export async function readLog(
  api: ApiClient,
  buildId: string,
  offset: number,
  signal?: AbortSignal,
): Promise<{ bytes: ArrayBuffer; end: number }> {
  const { data, response } = await api.GET('/api/v1/builds/{id}/log', {
    params: { path: { id: buildId }, query: { offset } },
    parseAs: 'arrayBuffer',
    ...(signal && { signal }),
  });
  if (!response.ok) throw new Error(`The server answered ${response.status}.`);
  const bytes = data ?? new ArrayBuffer(0);
  const end = Number(response.headers.get('Sitaf-Log-End') ?? offset + bytes.byteLength);
  return { bytes, end };
}
