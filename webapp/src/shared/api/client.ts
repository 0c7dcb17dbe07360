import createClient, { type Client } from 'openapi-fetch';
import type { Connection } from './connection';
import { ConnectionLostError } from './errors';
import type { paths } from './schema';

export type ApiClient = Client<paths>;

/** Longer than any long poll (20 s). */
const READ_TIMEOUT_MS = 40_000;

/** The status codes of a gateway whose server is not available. */
const GATEWAY_STATUS: readonly number[] = [502, 503, 504];

/** A typed client of the server at `baseUrl`. Reports to `connection` whether the server responds. */
export function createApi(baseUrl: string, connection: Connection): ApiClient {
  return createClient<paths>({
    baseUrl,
    fetch: async (request) => {
      const token = csrfToken();
      if (token !== undefined) request.headers.set('X-XSRF-TOKEN', token);
      try {
        const response = await fetch(request, { signal: timeoutOf(request) });
        connection.report(!GATEWAY_STATUS.includes(response.status));
        return response;
      } catch (cause) {
        // An aborted request does not mean that the connection is lost.
        if (request.signal.aborted) throw cause;
        connection.report(false);
        throw new ConnectionLostError(cause);
      }
    },
  });
}

/** The CSRF token. Other sites cannot read it, so it proves that the portal sent the request. */
function csrfToken(): string | undefined {
  return /(?:^|; )XSRF-TOKEN=([^;]+)/.exec(document.cookie)?.[1];
}

/** Uploads have no timeout. */
function timeoutOf(request: Request): AbortSignal {
  return request.method === 'GET'
    ? AbortSignal.any([request.signal, AbortSignal.timeout(READ_TIMEOUT_MS)])
    : request.signal;
}
