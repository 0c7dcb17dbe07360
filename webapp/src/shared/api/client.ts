import createClient, { type Client } from 'openapi-fetch';
import type { Connection } from './connection';
import { ConnectionLostError } from './errors';
import type { paths } from './schema';

export type ApiClient = Client<paths>;

/** Longer than any long poll (20 s); an answer later than this counts as none. */
const READ_TIMEOUT_MS = 40_000;

/** What a gateway says in the place of a server that is not there. */
const GATEWAY_STATUS: readonly number[] = [502, 503, 504];

/** A typed client of the server at `baseUrl` that reports to `connection` whether it answers. */
export function createApi(baseUrl: string, connection: Connection): ApiClient {
  return createClient<paths>({
    baseUrl,
    fetch: async (request) => {
      const token = csrfToken();
      if (token !== undefined) request.headers.set('X-XSRF-TOKEN', token);
      try {
        const response = await fetch(request, { signal: patience(request) });
        connection.report(!GATEWAY_STATUS.includes(response.status));
        return response;
      } catch (cause) {
        // Whoever asked has gone away: that says nothing of the server.
        if (request.signal.aborted) throw cause;
        connection.report(false);
        throw new ConnectionLostError(cause);
      }
    },
  });
}

/** What the server gave this browser, and no other site can read: the proof that the portal asks. */
function csrfToken(): string | undefined {
  return /(?:^|; )XSRF-TOKEN=([^;]+)/.exec(document.cookie)?.[1];
}

/** Uploads may take as long as they need. */
function patience(request: Request): AbortSignal {
  return request.method === 'GET'
    ? AbortSignal.any([request.signal, AbortSignal.timeout(READ_TIMEOUT_MS)])
    : request.signal;
}
