import { createServer, type IncomingMessage, type Server, type ServerResponse } from 'node:http';
import type { AddressInfo } from 'node:net';
import { unzipSync } from 'fflate';
import type {
  Activity,
  ActivityDescription,
  ActivityProposal,
  Agent,
  Build,
  BuildAnalysis,
  BuildRequest,
  CaseHistory,
  CaseSignals,
  Diagnostic,
  Difference,
  GitBisection,
  GitCommit,
  GitRequest,
  GitSource,
  ModelPreview,
  ResultCase,
  ResultComparison,
  ResultFailures,
  ValueComparison,
  SuiteCase,
} from '@/shared/api';
import { AGENT, activity, build, gitBisection, result, suite } from './samples';

/** Size of a part of a log in bytes. */
export const LOG_PART = 1_000;

type Handler = (context: {
  request: IncomingMessage;
  path: string[];
  query: URLSearchParams;
  body: Buffer;
}) => Promise<Answer> | Answer;

interface Answer {
  status: number;
  json?: unknown;
  text?: string;
  /** A binary body. */
  bytes?: Uint8Array;
  headers?: Record<string, string>;
  problem?: boolean;
}

interface ExpectedChange {
  no: number;
  literal?: string;
}

/** The fixed segments of paths; all other segments are identifiers. */
const NOUNS = [
  'activities',
  'activity-checks',
  'activity-proposals',
  'agents',
  'builds',
  'cancel',
  'tags',
  'build',
  'calendars',
  'case-history',
  'commits',
  'cases',
  'causes',
  'comparison',
  'coverage',
  'description',
  'differences',
  'expected',
  'explanation',
  'failures',
  'files',
  'bisections',
  'git',
  'log',
  'model-previews',
  'models',
  'not-comparable',
  'preview',
  'proposals',
  'recordings',
  'repetition',
  'requests',
  'result',
  'run',
  'schedules',
  'score',
  'sequences',
  'session',
  'signals',
  'suites',
  'values',
];

/** The REST interface of the server with data in memory, on a free port of the loopback interface. */
export class FakeServer {
  readonly activities: Activity[] = [];
  readonly builds: Build[] = [];
  readonly cases = new Map<string, ResultCase[]>();
  /** What failed in any result. */
  failures: ResultFailures = { groups: [], leftOut: 0 };
  /** Of any two builds. */
  comparison: ResultComparison | undefined;
  /** Of any two builds; without it, their parameters differ. */
  values: ValueComparison | undefined;
  /** By index of the group. */
  readonly differences = new Map<string, Difference[]>();

  /** Finished cases of builds that have no result yet. */
  readonly liveCases = new Map<string, ResultCase[]>();
  /** The logs of builds. Like the server, it sends them in parts of at most `LOG_PART` bytes. */
  readonly logs = new Map<string, string>();
  /** The output of cases by build and number, such as `b1 7`. */
  readonly caseLogs = new Map<string, string>();
  /** Binary glTF by build and case: `b1 7`. */
  readonly recordings = new Map<string, Uint8Array>();
  /** Bodies of requests for analyses. */
  readonly analysisRequests: unknown[] = [];
  /** Explanations, scores and repetitions: `b1 explanation`. */
  readonly analyses = new Map<string, BuildAnalysis>();
  /** The analysis that a request gets. */
  requestedAnalysis: BuildAnalysis | undefined;
  /** The signals of cases: `b1 7`. */
  readonly signals = new Map<string, CaseSignals>();
  agents: Agent[] = [AGENT];
  readonly buildRequests: BuildRequest[] = [];
  readonly scheduleRequests: unknown[] = [];
  /** The problems of the next upload; it is accepted if there are none. */
  refusal: Diagnostic[] = [];
  /** `METHOD /path?query` of every request, in order. */
  readonly requests: string[] = [];
  readonly suiteOptions: unknown[] = [];
  /** Documents of test models by name. */
  readonly models = new Map<string, string>();
  /** The If-Match headers of changed models. */
  readonly modelVersions: (string | undefined)[] = [];
  /** Texts of files of the activity by path. */
  readonly files = new Map<string, string>();
  /** Documents for which a preview was requested. */
  readonly previews: string[] = [];
  /** What a preview answers. */
  preview: ModelPreview = { inputs: [], calls: [], diagnostics: [] };
  /** The document of a proposed model of sequences. */
  proposal = '';
  description: ActivityDescription = { provided: [], required: [], warnings: [] };
  /** Zip files whose problems were requested. */
  readonly checks: Buffer[] = [];
  /** The answer to these requests. */
  problems: Diagnostic[] = [];
  /** Queries and zip files from which an activity was to be proposed. */
  readonly proposals: { query: Record<string, string>; zip: Buffer }[] = [];
  /** The proposed activity. */
  proposedActivity: ActivityProposal = { notes: [], files: [], archive: '' };
  /** The problems of the next proposal; it succeeds if there are none. */
  proposalRefusal: Diagnostic[] = [];
  /** The nodes of a package of which none was chosen. */
  nodes: string[] = [];
  suiteCases: SuiteCase[] = [];
  suiteVersion = 1;
  /** Stored changes of expected values with the version of the request. */
  readonly suiteEdits: { ifMatch: string | undefined; changes: ExpectedChange[] }[] = [];
  readonly uploads: Buffer[] = [];
  /** Of the signed-in user. */
  role = 'TESTER';
  /** Of any activity. */
  gitSource: GitSource | undefined;
  /** The histories of cases by their numbers. */
  readonly caseHistories = new Map<number, CaseHistory>();
  /** Commits of the branch, and of pull or merge requests. */
  readonly gitCommits: GitCommit[] = [];
  readonly gitBisections: GitBisection[] = [];
  readonly gitRequests: GitRequest[] = [];
  /** Heads that somebody asked to build. */
  readonly builtHeads: unknown[] = [];

  private http: Server | undefined;
  private port = 0;
  private readonly waiting = new Set<() => void>();

  get url(): string {
    return `http://127.0.0.1:${this.port}`;
  }

  /** Starts, or starts again on the same port. */
  async start(): Promise<void> {
    const http = createServer((request, response) => {
      void this.serve(request, response);
    });
    await new Promise<void>((resolve) => http.listen(this.port, '127.0.0.1', resolve));
    this.port = (http.address() as AddressInfo).port;
    this.http = http;
  }

  async stop(): Promise<void> {
    const { http } = this;
    if (!http) return;
    this.http = undefined;
    http.closeAllConnections();
    await new Promise((resolve) => http.close(resolve));
  }

  /** Changes a build and answers the long polls. */
  advance(id: string, changes: Partial<Build>): void {
    const index = this.builds.findIndex((item) => item.id === id);
    const old = this.builds[index];
    if (!old) throw new Error(`No build ${id}`);
    this.builds[index] = { ...old, ...changes, version: old.version + 1 };
    for (const wake of this.waiting) wake();
    this.waiting.clear();
  }

  private async serve(request: IncomingMessage, response: ServerResponse): Promise<void> {
    const url = new URL(request.url ?? '/', this.url);
    if (request.method === 'OPTIONS') {
      response.writeHead(204, {
        'Access-Control-Allow-Origin': '*',
        'Access-Control-Allow-Methods': '*',
        'Access-Control-Allow-Headers': '*, if-match, content-type',
      });
      response.end();
      return;
    }
    this.requests.push(`${request.method} ${url.pathname}${url.search}`);
    const path = url.pathname.split('/').slice(3).map(decodeURIComponent);
    const chunks: Buffer[] = [];
    for await (const chunk of request) chunks.push(chunk as Buffer);
    const { status, json, text, bytes, problem, headers } = await this.route(
      request.method ?? 'GET',
      path,
    )({
      request,
      path,
      query: url.searchParams,
      body: Buffer.concat(chunks),
    });
    response.writeHead(status, {
      'Content-Type':
        text !== undefined
          ? 'text/plain'
          : problem
            ? 'application/problem+json'
            : 'application/json',
      // The page of jsdom has a different origin.
      'Access-Control-Allow-Origin': '*',
      'Access-Control-Allow-Methods': '*',
      'Access-Control-Allow-Headers': '*',
      'Access-Control-Expose-Headers': 'ETag, Sitaf-Log-End',
      ...headers,
    });
    response.end(bytes ?? text ?? JSON.stringify(json));
  }

  private route(method: string, path: string[]): Handler {
    const shape = [method, ...path.map((part) => (NOUNS.includes(part) ? part : '*'))].join(' ');
    return this.handlers[shape] ?? (() => notFound());
  }

  private readonly handlers: Record<string, Handler> = {
    'GET agents': () => ({ status: 200, json: this.agents }),
    'GET activities': ({ query }) => {
      const search = query.get('search') ?? '';
      const wanted = query.getAll('tag');
      const shown = this.activities.filter(
        ({ name, tags }) => name.includes(search) && wanted.every((tag) => tags.includes(tag)),
      );
      return { status: 200, json: pageOf(shown, query) };
    },
    'GET activities *': ({ path }) => found(this.activities.find(({ id }) => id === path[1])),
    'GET tags': () => ({
      status: 200,
      json: [...new Set(this.activities.flatMap(({ tags }) => tags))].sort().map((name) => ({
        name,
        activities: this.activities.filter(({ tags }) => tags.includes(name)).length,
      })),
    }),
    'PUT activities * tags': ({ path, body }) => {
      const changed = this.activities.find(({ id }) => id === path[1]);
      const { tags } = JSON.parse(body.toString()) as { tags: string[] };
      if (tags.includes('two words')) {
        const detail = "tags: 'two words' must have 1 to 50 letters.";
        return { status: 400, problem: true, json: { title: 'Malformed', detail, status: 400 } };
      }
      if (changed) changed.tags = [...tags].sort();
      return found(changed);
    },
    'POST activities': ({ body, request }) => this.upload(body, request),
    'POST activities * models * suites': ({ path, body }) => {
      this.suiteOptions.push(JSON.parse(body.toString()));
      return { status: 201, json: suite('s1', path[1] ?? '', path[3] ?? '') };
    },
    'GET activities * models *': ({ path }) => {
      const text = this.models.get(path[3] ?? '');
      const version = this.activities.find(({ id }) => id === path[1])?.version ?? 1;
      return text === undefined
        ? notFound()
        : { status: 200, text, headers: { ETag: `"${version}"` } };
    },
    'PUT activities * models *': ({ path, body, request }) => {
      const ifMatch = request.headers['if-match'];
      const changed = this.activities.find(({ id }) => id === path[1]);
      if (ifMatch !== `"${changed?.version ?? 0}"`) return conflict();
      this.modelVersions.push(ifMatch);
      this.models.set(path[3] ?? '', body.toString());
      return found(changed);
    },
    'GET activities * files *': ({ path }) => ({
      status: 200,
      text: this.files.get(path[3] ?? '') ?? '',
    }),
    'PATCH activities * files': ({ path, body }) => {
      const { changes } = JSON.parse(body.toString()) as {
        changes: { path: string; content?: string }[];
      };
      const changed = this.activities.find(({ id }) => id === path[1]);
      for (const change of changes) {
        if (change.content === undefined) {
          if (changed) changed.files = changed.files.filter((file) => file.path !== change.path);
          continue;
        }
        this.files.set(change.path, change.content);
        if (change.path.endsWith('.xml')) {
          this.models.set(change.path.replace('.xml', ''), change.content);
        }
      }
      return found(changed);
    },
    'POST activities * files': ({ path, body, request }) => {
      const changed = this.activities.find(({ id }) => id === path[1]);
      if (!changed) return notFound();
      if (request.headers['if-match'] !== `"${changed.version}"`) {
        return { status: 412, problem: true, json: { title: 'Outdated', status: 412 } };
      }
      for (const [added, bytes] of Object.entries(unzipSync(body))) {
        changed.files.push({ path: added, size: bytes.length, sha256: 'c'.repeat(64) });
      }
      changed.version++;
      return { status: 200, json: changed };
    },
    'GET activities * description': () => ({ status: 200, json: this.description }),
    'POST activities * model-previews': ({ body }) => {
      this.previews.push(body.toString());
      return { status: 200, json: this.preview };
    },
    'GET activities * case-history': ({ query }) => {
      const history = this.caseHistories.get(Number(query.get('no')));
      if (!history) return notFound();
      const by = query.get('by') === 'BUILDS' ? 'BUILDS' : history.by;
      return { status: 200, json: { ...history, ...pageOf(history.items, query), by } };
    },
    'GET activities * git': () => found(this.gitSource),
    'GET activities * git commits': ({ query }) => {
      const request = Number(query.get('request') ?? 0);
      return {
        status: 200,
        json: pageOf(
          this.gitCommits.filter((commit) => commit.request === request),
          query,
        ),
      };
    },
    'GET activities * git bisections': ({ query }) => ({
      status: 200,
      json: pageOf(this.gitBisections, query),
    }),
    'POST activities * git bisections': ({ body }) => {
      const { commit } = JSON.parse(body.toString()) as { commit: string };
      const running = this.gitBisections.find(({ state }) => state === 'RUNNING');
      if (running) {
        return {
          status: 409,
          problem: true,
          json: { title: 'Conflict', detail: `Search ${running.number} runs.`, status: 409 },
        };
      }
      const begun = gitBisection(this.gitBisections.length + 1, commit);
      this.gitBisections.unshift(begun);
      return { status: 201, json: begun };
    },
    'POST activities * git bisections * cancel': ({ path }) => {
      const search = this.gitBisections.find(({ number }) => number === Number(path[4]));
      if (!search) return notFound();
      search.state = 'CANCELLED';
      return { status: 200, json: search };
    },
    'GET activities * git requests': ({ query }) => {
      const state = query.get('state');
      return {
        status: 200,
        json: pageOf(
          this.gitRequests.filter((request) => !state || request.state === state),
          query,
        ),
      };
    },
    'POST activities * git requests * build': ({ path, body }) => {
      const asked = JSON.parse(body.toString()) as { head: string };
      const request = this.gitRequests.find(({ number }) => number === Number(path[4]));
      if (!request) return notFound();
      if (request.head !== asked.head) {
        return {
          status: 409,
          problem: true,
          json: { title: 'Conflict', detail: `The head is now ${request.head}.`, status: 409 },
        };
      }
      this.builtHeads.push(asked.head);
      request.waitsForApproval = false;
      return { status: 202, json: request };
    },
    'GET activities * proposals sequences': () => ({ status: 200, text: this.proposal }),
    'POST activity-checks': ({ body }) => {
      this.checks.push(body);
      return { status: 200, json: { diagnostics: this.problems } };
    },
    'POST activity-proposals': ({ body, query }) => {
      this.proposals.push({ query: Object.fromEntries(query), zip: body });
      if (this.nodes.length > 0 && !query.has('class')) {
        return refused({ title: 'Several nodes', nodes: this.nodes });
      }
      return this.proposalRefusal.length > 0
        ? refused({ title: 'Invalid input', diagnostics: this.proposalRefusal })
        : { status: 200, json: this.proposedActivity };
    },
    'GET builds * explanation': ({ path }) =>
      foundOrNone(this.analyses.get(`${path[1]} explanation`)),
    'POST builds * explanation': ({ path }) => {
      if (!this.requestedAnalysis) return conflict();
      this.analyses.set(`${path[1]} explanation`, this.requestedAnalysis);
      return { status: 201, json: this.requestedAnalysis };
    },
    'GET builds * score': ({ path }) => foundOrNone(this.analyses.get(`${path[1]} score`)),
    'POST builds * score': ({ path }) => {
      if (!this.requestedAnalysis) return conflict();
      this.analyses.set(`${path[1]} score`, this.requestedAnalysis);
      return { status: 201, json: this.requestedAnalysis };
    },
    'GET builds * repetition': ({ path }) =>
      foundOrNone(this.analyses.get(`${path[1]} repetition`)),
    'POST builds * repetition': ({ path, body }) => {
      if (!this.requestedAnalysis) return conflict();
      this.analysisRequests.push(JSON.parse(body.toString()));
      this.analyses.set(`${path[1]} repetition`, this.requestedAnalysis);
      return { status: 201, json: this.requestedAnalysis };
    },
    'POST builds * explanation causes * run': () => ({ status: 201, json: { id: 'b2' } }),
    'GET session': () => ({
      status: 200,
      json: { name: 'tester', role: this.role, kind: 'PERSON' },
    }),
    'GET schedules': ({ query }) => ({ status: 200, json: pageOf([], query) }),
    'GET activities * suites': ({ query }) => ({ status: 200, json: pageOf([], query) }),
    'GET suites *': () => ({ status: 200, json: this.suite() }),
    'GET suites * cases': ({ query }) => ({ status: 200, json: pageOf(this.suiteCases, query) }),
    'PATCH suites * expected': ({ body, request }) => this.changeExpected(body, request),
    'GET builds': ({ query }) => {
      const activityId = query.get('activityId');
      const search = query.get('search') ?? '';
      const state = query.get('state');
      const shown = this.builds.filter(
        (item) =>
          (!activityId || item.activityId === activityId) &&
          (!state || item.state === state) &&
          item.activityName.includes(search),
      );
      return { status: 200, json: pageOf(shown, query) };
    },
    'POST builds': ({ body }) => {
      const request = JSON.parse(body.toString()) as BuildRequest;
      this.buildRequests.push(request);
      const { recordings = 'ALL', ...options } = request;
      const id = `b${this.builds.length + 1}`;
      const created = build(id, { ...options, recordedCases: recordings });
      this.builds.unshift(created);
      return { status: 201, json: created };
    },
    'GET builds *': async ({ path, query }) => {
      const find = () => this.builds.find(({ id }) => id === path[1]);
      if (String(find()?.version) === query.get('waitForChangeSince')) await this.change();
      return found(find());
    },
    'GET builds * result': ({ path }) => {
      const cases = this.cases.get(path[1] ?? '');
      const suspicions = this.builds.find(({ id }) => id === path[1])?.suspicions ?? [];
      return cases ? { status: 200, json: { ...result(cases), suspicions } } : notFound();
    },
    'GET builds * result cases': ({ path, query }) => {
      const verdict = query.get('verdict');
      const cases = this.cases.get(path[1] ?? '') ?? [];
      const shown = cases.filter((item) => !verdict || item.verdict === verdict);
      return { status: 200, json: pageOf(shown, query) };
    },
    'GET builds * cases': ({ path, query }) => ({
      status: 200,
      json: pageOf(this.liveCases.get(path[1] ?? '') ?? [], query),
    }),
    'GET builds * log': ({ path, query }) => {
      const log = Buffer.from(this.logs.get(path[1] ?? '') ?? '');
      const offset = Number(query.get('offset') ?? 0);
      return {
        status: 200,
        bytes: log.subarray(offset, offset + LOG_PART),
        headers: { 'Content-Type': 'text/plain', 'Sitaf-Log-End': String(log.length) },
      };
    },
    'GET builds * cases * log': ({ path }) => ({
      status: 200,
      text: this.caseLogs.get(`${path[1]} ${path[3]}`) ?? '',
    }),
    'GET builds * result comparison values': () =>
      this.values
        ? { status: 200, json: this.values }
        : { status: 409, json: { title: 'Conflict', detail: 'their parameters differ' } },
    'GET builds * result comparison differences': ({ query }) => {
      const items = this.differences.get(query.get('group') ?? query.get('part') ?? '') ?? [];
      return { status: 200, json: { items, page: 0, size: 50, total: items.length } };
    },
    'GET builds * result comparison not-comparable': () => ({
      status: 200,
      json: {
        items: [{ no: 0, output: 'peak', reason: 'only NEW has it' }],
        page: 0,
        size: 50,
        total: 1,
      },
    }),
    'GET builds * result comparison': () => ({ status: 200, json: this.comparison }),
    'GET builds * result failures': () => ({ status: 200, json: this.failures }),
    'GET builds * result coverage': () => ({
      status: 200,
      json: {
        measured: true,
        statement: 75,
        files: [{ path: 'component/A.java', lines: 4, reached: 3, branches: 0, taken: 0 }],
      },
    }),
    'GET builds * result coverage *': () => ({
      status: 200,
      json: {
        path: 'component/A.java',
        source: 'class A {}\n',
        lines: [1, 2, 3, 4].map((number) => ({
          number,
          reached: number !== 4,
          branches: 0,
          taken: 0,
        })),
      },
    }),
    'GET calendars': () => ({ status: 200, json: [] }),
    'POST schedules': ({ body }) => {
      this.scheduleRequests.push(JSON.parse(body.toString()));
      return { status: 201, json: { id: 'p1' } };
    },
    'POST schedules preview': ({ body }) => {
      const { cron } = JSON.parse(body.toString()) as { cron?: string };
      return cron?.startsWith('0 3') === true
        ? {
            status: 200,
            json: Array.from({ length: 10 }, (_, n) => `2099-03-${10 + n}T03:00:00Z`),
          }
        : {
            status: 400,
            problem: true,
            json: { title: 'Malformed', detail: 'is not a cron expression', status: 400 },
          };
    },
    'GET builds * recordings': ({ path, query }) => {
      const items = [...this.recordings]
        .filter(([key]) => key.startsWith(`${path[1] ?? ''} `))
        .map(([key, { byteLength }]) => ({
          caseNo: Number(key.split(' ')[1]),
          sha256: key,
          size: byteLength,
          received: '2026-03-01T10:00:00Z',
        }));
      if (query.get('order') === 'NEWEST') items.reverse();
      return { status: 200, json: pageOf(items, query) };
    },
    'GET builds * cases * signals': ({ path }) =>
      foundOrNone(this.signals.get(`${path[1] ?? ''} ${path[3] ?? ''}`)),
    'GET builds * recordings *': ({ path }) => {
      const bytes = this.recordings.get(`${path[1] ?? ''} ${path[3] ?? ''}`);
      return bytes ? { status: 200, bytes } : notFound();
    },
    'POST builds * cancel': ({ path }) => {
      this.advance(path[1] ?? '', { state: 'CANCELLED' });
      return found(this.builds.find(({ id }) => id === path[1]));
    },
  };

  private suite() {
    const total = this.suiteCases.length;
    return { ...suite('s1', 'a1', 'GetInfraredData'), version: this.suiteVersion, total };
  }

  private changeExpected(body: Buffer, request: IncomingMessage): Answer {
    const ifMatch = request.headers['if-match'];
    if (ifMatch !== `"${this.suiteVersion}"`) {
      return conflict();
    }
    const { changes } = JSON.parse(body.toString()) as { changes: ExpectedChange[] };
    this.suiteEdits.push({ ifMatch, changes });
    this.suiteVersion++;
    this.suiteCases = this.suiteCases.map((item) => {
      const change = changes.find(({ no }) => no === item.no);
      return change?.literal ? { ...item, expected: { return: change.literal } } : item;
    });
    return { status: 200, json: this.suite() };
  }

  private upload(body: Buffer, request: IncomingMessage): Answer {
    if (request.headers['content-type'] !== 'application/zip') return notFound();
    this.uploads.push(body);
    if (this.refusal.length > 0) {
      return {
        status: 422,
        problem: true,
        json: {
          title: 'The input cannot be used',
          detail: this.refusal.map(({ file, message }) => `${file}: ${message}`).join('\n'),
          status: 422,
          diagnostics: this.refusal,
        },
      };
    }
    const created = activity(`a${this.activities.length + 1}`, { name: 'uploaded' });
    this.activities.push(created);
    return { status: 201, json: created };
  }

  private change(): Promise<void> {
    return new Promise((resolve) => this.waiting.add(resolve));
  }
}

function found(item: unknown): Answer {
  return item ? { status: 200, json: item } : notFound();
}

function foundOrNone(item: unknown): Answer {
  return item ? { status: 200, json: item } : { status: 204 };
}

function conflict(): Answer {
  return { status: 412, problem: true, json: { title: 'Version conflict', status: 412 } };
}

function refused(problem: object): Answer {
  return { status: 422, problem: true, json: { status: 422, ...problem } };
}

function notFound(): Answer {
  return { status: 404, problem: true, json: { title: 'Not found', status: 404 } };
}

function pageOf<T>(all: readonly T[], query: URLSearchParams) {
  const page = Number(query.get('page') ?? 0);
  const size = Number(query.get('size') ?? 50);
  return {
    items: all.slice(page * size, (page + 1) * size),
    page,
    size,
    total: all.length,
  };
}
