import type { Diagnostic, Problem } from './types';

/** The server refused the request (RFC 9457 problem details). */
export class ApiError extends Error {
  override readonly name = 'ApiError';
  readonly title: string;
  readonly diagnostics: readonly Diagnostic[];
  /** Of these nodes of a ROS 2 package, one must be chosen. */
  readonly nodes: readonly string[];

  constructor(
    readonly status: number,
    problem: Partial<Problem>,
  ) {
    const title = problem.title ?? `The server answered ${status}`;
    super(problem.detail ?? title);
    this.title = title;
    this.diagnostics = problem.diagnostics ?? [];
    this.nodes = problem.nodes ?? [];
  }
}

/** There was no response: the server is down, unreachable or too slow. */
export class ConnectionLostError extends Error {
  override readonly name = 'ConnectionLostError';

  constructor(cause: unknown) {
    super('The server does not respond. Is it running?', { cause });
  }
}

interface Answer<T> {
  data?: T;
  error?: unknown;
  response: Response;
}

/** The data of a response. Throws an {@link ApiError} if the server refused the request. */
export async function dataOf<T>(call: Promise<Answer<T>>): Promise<T> {
  const { data, error, response } = await call;
  if (!response.ok) throw new ApiError(response.status, asProblem(error));
  return data as T;
}

/** A proxy may respond with HTML or text; only an object is a problem. */
function asProblem(body: unknown): Partial<Problem> {
  return typeof body === 'object' && body !== null ? body : {};
}
