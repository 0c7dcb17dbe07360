import { Badge, Stack, Table, Text, Tooltip } from '@mantine/core';
import type { GitCell, GitCommit } from '@/shared/api';
import { shortCommit } from '@/shared/lib/commits';
import { Age, Loading, Pager, ProblemAlert, RouteLink, ScrollTable, UserText } from '@/shared/ui';
import { BeginBisection, hasUnknownOrigin } from './BeginBisection';
import { COMMITS_PER_PAGE, useGitCommits } from './queries';

interface BranchTableProps {
  activityId: string;
  /** A pull or merge request; absent for the branch. */
  request?: number | undefined;
  /** From 0. */
  page: number;
  onPage: (page: number) => void;
  /** The commit of a link in a status. */
  marked?: string | undefined;
  /** Whether the user may let commits be built. */
  mayBuild: boolean;
}

/**
 * Commits as rows, models as columns; each cell says what differs from the commit before, or from
 * the merge base of a request.
 */
export function BranchTable({
  activityId,
  request,
  page,
  onPage,
  marked,
  mayBuild,
}: BranchTableProps) {
  const commits = useGitCommits(activityId, request, page);
  if (commits.isPending) return <Loading what="the commits" />;
  if (!commits.data) {
    return <ProblemAlert title="The commits could not be read" error={commits.error} />;
  }
  const { items, total } = commits.data;
  if (items.length === 0) return <Text c="dimmed">No commits yet.</Text>;
  const models = [...new Set(items.flatMap(({ cells }) => cells.map(({ model }) => model)))];
  return (
    <Stack gap="sm">
      <ScrollTable label="Commits" minWidth={640}>
        <Table.Thead>
          <Table.Tr>
            <Table.Th>Commit</Table.Th>
            {models.map((model) => (
              <Table.Th key={model}>
                <UserText>{model}</UserText>
              </Table.Th>
            ))}
          </Table.Tr>
        </Table.Thead>
        <Table.Tbody>
          {items.map((commit) => (
            <CommitRow
              key={commit.sha}
              activityId={activityId}
              ofRequest={request !== undefined}
              commit={commit}
              mayBuild={mayBuild}
              models={models}
              marked={commit.sha === marked}
            />
          ))}
        </Table.Tbody>
      </ScrollTable>
      <Pager
        label="Pages of commits"
        page={page}
        size={COMMITS_PER_PAGE}
        total={total}
        onPage={onPage}
      />
    </Stack>
  );
}

interface CommitRowProps {
  activityId: string;
  /** The commits of a request are not in the history of a case. */
  ofRequest: boolean;
  mayBuild: boolean;
  commit: GitCommit;
  models: readonly string[];
  marked: boolean;
}

function CommitRow({ activityId, ofRequest, commit, models, marked, mayBuild }: CommitRowProps) {
  return (
    <Table.Tr aria-current={marked ? 'true' : undefined}>
      <Table.Td>
        <Text size="sm" fw={marked ? 700 : 500}>
          <UserText>{commit.subject}</UserText>
        </Text>
        <Text size="xs" c="dimmed">
          <UserText>{`${shortCommit(commit.sha)} · ${commit.author} · `}</UserText>
          <Age at={commit.authored} />
        </Text>
        {commit.replaced && (
          <Badge size="sm" color="gray">
            Removed by a force-push
          </Badge>
        )}
        {commit.mergeBase && (
          <Badge size="sm" color="gray">
            Merge base
          </Badge>
        )}
        {commit.problem && (
          <Text size="sm" c="red">
            <UserText>{commit.problem}</UserText>
          </Text>
        )}
        {mayBuild && hasUnknownOrigin(commit) && (
          <BeginBisection activityId={activityId} commit={commit} />
        )}
      </Table.Td>
      {models.map((model) => {
        const cell = commit.cells.find((one) => one.model === model);
        return (
          <Table.Td key={model}>
            {cell ? (
              <Cell activityId={ofRequest ? undefined : activityId} commit={commit} cell={cell} />
            ) : (
              <NoCell commit={commit} />
            )}
          </Table.Td>
        );
      })}
    </Table.Tr>
  );
}

function NoCell({ commit }: { commit: GitCommit }) {
  const text = {
    WAITING: 'Waiting',
    SKIPPED: 'Not built',
    INVALID: 'Cannot be built',
    BUILDING: '–',
    DONE: '–',
  }[commit.state];
  return (
    <Text size="sm" c="dimmed">
      {text}
    </Text>
  );
}

interface CellProps {
  /** Absent without a history of cases. */
  activityId: string | undefined;
  commit: GitCommit;
  cell: GitCell;
}

function Cell({ activityId, commit, cell }: CellProps) {
  return (
    <Stack gap={2}>
      <RouteLink to="/builds/$buildId" params={{ buildId: cell.buildId }} size="sm">
        {cell.total === undefined ? stateOf(cell) : `${cell.pass} of ${cell.total} passed`}
      </RouteLink>
      {cell.differing !== undefined && cell.differing > 0 && cell.baseBuildId && (
        <RouteLink
          to="/builds/$buildId/compare"
          params={{ buildId: cell.buildId }}
          search={{ with: cell.baseBuildId }}
          size="xs"
        >
          {cell.differing === 1 ? '1 case differs' : `${cell.differing} cases differ`}
        </RouteLink>
      )}
      {cell.differing === 0 && !cell.takenFrom && (
        <Text size="xs" c="dimmed">
          No differences
        </Text>
      )}
      {cell.takenFrom && (
        <Tooltip label={`${shortCommit(commit.sha)} changes nothing that this test reads.`}>
          <Text size="xs" c="dimmed">
            {`Taken over from ${shortCommit(cell.takenFrom)}`}
          </Text>
        </Tooltip>
      )}
      {cell.suspect && (
        <Badge size="sm" color="red">
          Suspect
        </Badge>
      )}
      {activityId && cell.total !== undefined && (
        <RouteLink
          to="/activities/$activityId/history/$model"
          params={{ activityId, model: cell.model }}
          search={{ build: cell.buildId }}
          size="xs"
          aria-label={`History of the cases of ${cell.model} at ${shortCommit(commit.sha)}`}
        >
          History of cases
        </RouteLink>
      )}
    </Stack>
  );
}

function stateOf(cell: GitCell): string {
  switch (cell.state) {
    case 'FAILED':
      return 'Build failed';
    case 'CANCELLED':
      return 'Cancelled';
    case 'QUEUED':
      return 'Queued';
    default:
      return 'Running';
  }
}
