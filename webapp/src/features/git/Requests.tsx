import { Badge, Button, NativeSelect, Stack, Table, Text } from '@mantine/core';
import { useState } from 'react';
import type { GitCommit, GitRequest } from '@/shared/api';
import { shortCommit } from '@/shared/lib/commits';
import {
  Age,
  Loading,
  Pager,
  ProblemAlert,
  RouteLink,
  ScrollTable,
  Section,
  UserText,
} from '@/shared/ui';
import {
  REQUESTS_PER_PAGE,
  useBuildGitRequest,
  useGitRequests,
  type GitRequestState,
} from './queries';
import { nounOf } from './requestNouns';

interface RequestsProps {
  activityId: string;
  /** GitLab calls them merge requests. */
  forge: string;
  /** Whether the user may let the code of a request run. */
  mayBuild: boolean;
}

/** The pull or merge requests into the branch, with the results of their newest commits. */
export function Requests({ activityId, forge, mayBuild }: RequestsProps) {
  const [state, setState] = useState<GitRequestState | undefined>('OPEN');
  const [page, setPage] = useState(0);
  const noun = nounOf(forge);
  return (
    <Section
      title={`${noun}s`}
      actions={
        <NativeSelect
          aria-label={`${noun}s to show`}
          size="sm"
          value={state ?? ''}
          data={[
            { value: 'OPEN', label: 'Open' },
            { value: 'CLOSED', label: 'Closed' },
            { value: '', label: 'All' },
          ]}
          onChange={(event) => {
            const chosen = event.currentTarget.value;
            setState(chosen === 'OPEN' || chosen === 'CLOSED' ? chosen : undefined);
            setPage(0);
          }}
        />
      }
    >
      <RequestTable
        activityId={activityId}
        noun={noun}
        mayBuild={mayBuild}
        state={state}
        page={page}
        onPage={setPage}
      />
    </Section>
  );
}

interface RequestTableProps {
  activityId: string;
  noun: string;
  mayBuild: boolean;
  state: GitRequestState | undefined;
  /** From 0. */
  page: number;
  onPage: (page: number) => void;
}

function RequestTable({ activityId, noun, mayBuild, state, page, onPage }: RequestTableProps) {
  const requests = useGitRequests(activityId, state, page);
  const name = noun.toLowerCase();
  if (requests.isPending) return <Loading what={`the ${name}s`} />;
  if (!requests.data) {
    return <ProblemAlert title={`The ${name}s could not be read`} error={requests.error} />;
  }
  const { items, total } = requests.data;
  if (items.length === 0) {
    return (
      <Text c="dimmed">
        {`None. A webhook with the event ${name}s reports them when they are opened or pushed to.`}
      </Text>
    );
  }
  return (
    <Stack gap="sm">
      <ScrollTable label={`${noun}s`} minWidth={640}>
        <Table.Thead>
          <Table.Tr>
            <Table.Th>Request</Table.Th>
            <Table.Th>Result</Table.Th>
            {mayBuild && <Table.Th>Build</Table.Th>}
          </Table.Tr>
        </Table.Thead>
        <Table.Tbody>
          {items.map((request) => (
            <Table.Tr key={request.number}>
              <Table.Td>
                <Name activityId={activityId} request={request} />
              </Table.Td>
              <Table.Td>
                <Result request={request} />
              </Table.Td>
              {mayBuild && (
                <Table.Td>
                  {request.state === 'OPEN' && !isRunning(request) && (
                    <Build activityId={activityId} request={request} />
                  )}
                </Table.Td>
              )}
            </Table.Tr>
          ))}
        </Table.Tbody>
      </ScrollTable>
      <Pager
        label={`Pages of ${name}s`}
        page={page}
        size={REQUESTS_PER_PAGE}
        total={total}
        onPage={onPage}
      />
    </Stack>
  );
}

function Name({ activityId, request }: { activityId: string; request: GitRequest }) {
  return (
    <>
      <RouteLink
        to="/activities/$activityId"
        params={{ activityId }}
        search={{ tab: 'commits', request: request.number }}
        size="sm"
        fw={500}
      >
        <UserText>{`${request.number} ${request.title}`}</UserText>
      </RouteLink>
      <Text size="xs" c="dimmed">
        <UserText>{`${shortCommit(request.head)} · ${request.author} · `}</UserText>
        <Age at={request.updated} />
      </Text>
      {request.fork && (
        <Badge size="sm" color="gray">
          Fork
        </Badge>
      )}
      {request.state === 'CLOSED' && (
        <Badge size="sm" color="gray">
          Closed
        </Badge>
      )}
      {request.problem && (
        <Text size="sm" c="red">
          <UserText>{request.problem}</UserText>
        </Text>
      )}
    </>
  );
}

/** Whether builds of the head run or will run. */
function isRunning({ head, commit }: GitRequest): boolean {
  return commit?.sha === head && (commit.state === 'WAITING' || commit.state === 'BUILDING');
}

function Result({ request }: { request: GitRequest }) {
  const { commit, head } = request;
  return (
    <Stack gap={2} align="start">
      {request.waitsForApproval && (
        <Badge size="sm" color="yellow" miw="max-content">
          Waits for approval
        </Badge>
      )}
      {!commit && request.state === 'OPEN' && !request.waitsForApproval && !request.problem && (
        <Text size="sm" c="dimmed">
          Waiting
        </Text>
      )}
      {commit && (
        <>
          <Text size="sm">{verdictsOf(commit)}</Text>
          <Text size="xs" c="dimmed">
            {differencesOf(commit)}
          </Text>
          {commit.sha !== head && (
            <Text size="xs" c="dimmed">{`Result of ${shortCommit(commit.sha)}`}</Text>
          )}
        </>
      )}
    </Stack>
  );
}

function verdictsOf({ state, cells }: GitCommit): string {
  if (state !== 'DONE') {
    return {
      WAITING: 'Waiting',
      SKIPPED: 'Not built',
      INVALID: 'Cannot be built',
      BUILDING: 'Running',
    }[state];
  }
  if (cells.some(({ suspect }) => suspect)) return 'Suspect';
  if (cells.some(({ total }) => total === undefined)) return 'Build failed';
  return `${sum(cells.map(({ pass }) => pass))} of ${sum(cells.map(({ total }) => total))} passed`;
}

/** Nothing before the head was compared with the merge base. */
function differencesOf({ base, cells }: GitCommit): string {
  if (!base || cells.every(({ differing }) => differing === undefined)) return '';
  const differing = sum(cells.map((cell) => cell.differing));
  const cases = differing === 1 ? '1 case differs' : `${differing} cases differ`;
  return differing === 0
    ? `No differences to ${shortCommit(base)}`
    : `${cases} from ${shortCommit(base)}`;
}

function sum(numbers: readonly (number | undefined)[]): number {
  return numbers.reduce<number>((total, number) => total + (number ?? 0), 0);
}

function Build({ activityId, request }: { activityId: string; request: GitRequest }) {
  const build = useBuildGitRequest(activityId);
  const label = request.waitsForApproval ? 'Build' : 'Build again';
  return (
    <Stack gap={4} align="start">
      <Button
        size="compact-sm"
        variant="default"
        aria-label={`${label}: ${request.number}`}
        loading={build.isPending}
        onClick={() => {
          build.mutate({ number: request.number, head: request.head });
        }}
      >
        {label}
      </Button>
      {request.waitsForApproval && (
        <Text size="xs">
          {`Code of a fork will run on the agents. Look at its commits up to ${shortCommit(request.head)} first.`}
        </Text>
      )}
      {build.isError && (
        <ProblemAlert
          title="The build was not requested"
          error={build.error}
          onClose={build.reset}
        />
      )}
    </Stack>
  );
}
