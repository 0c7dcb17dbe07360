import { Badge, Button, Card, Group, List, Stack, Text } from '@mantine/core';
import type { GitBisection, GitBisectionCommit } from '@/shared/api';
import { shortCommit } from '@/shared/lib/commits';
import { Age, ProblemAlert, RouteLink, Section, UserText } from '@/shared/ui';
import { useCancelGitBisection, useGitBisections } from './queries';

interface BisectionsProps {
  activityId: string;
  /** Whether the user may cancel a search. */
  mayBuild: boolean;
}

/** The searches for first bad commits; nothing if there were none. */
export function Bisections({ activityId, mayBuild }: BisectionsProps) {
  const bisections = useGitBisections(activityId);
  if (bisections.isError && !bisections.data) {
    return <ProblemAlert title="The searches could not be read" error={bisections.error} />;
  }
  if (!bisections.data || bisections.data.items.length === 0) return null;
  return (
    <Section title="First bad commits">
      <Stack gap="sm">
        {bisections.data.items.map((search) => (
          <Search key={search.number} activityId={activityId} search={search} mayBuild={mayBuild} />
        ))}
      </Stack>
    </Section>
  );
}

interface SearchProps {
  activityId: string;
  search: GitBisection;
  mayBuild: boolean;
}

function Search({ activityId, search, mayBuild }: SearchProps) {
  const { number, state, commits, bad, good, builds } = search;
  return (
    <Card withBorder padding="sm" component="article" aria-label={`Search ${number}`}>
      <Stack gap="xs">
        <Group justify="space-between" align="start">
          <Stack gap={2} flex="1 1 16rem" miw={0}>
            <Text size="sm" fw={500}>
              {`${commits} commits after ${shortCommit(good)} up to ${shortCommit(bad)}`}
            </Text>
            <Text size="xs" c="dimmed">
              <UserText>{search.criterion}</UserText>
            </Text>
            <Text size="xs" c="dimmed">
              <UserText>{`${counted(builds, 'build')} · ${search.askedBy} · `}</UserText>
              <Age at={search.created} />
            </Text>
          </Stack>
          {state === 'RUNNING' && mayBuild && <Cancel activityId={activityId} number={number} />}
        </Group>
        <div role="status">
          <Progress search={search} />
        </div>
        {search.firstBad.map((commit) => (
          <FirstBad key={commit.sha} commit={commit} />
        ))}
        {search.problem && (
          <Text size="sm" c="red">
            <UserText>{search.problem}</UserText>
          </Text>
        )}
        <Tested commits={search.tested} />
      </Stack>
    </Card>
  );
}

function counted(count: number, noun: string): string {
  return count === 1 ? `1 ${noun}` : `${count} ${noun}s`;
}

function Progress({ search }: { search: GitBisection }) {
  switch (search.state) {
    case 'RUNNING':
      return (
        <Text size="sm">
          {search.testing
            ? `Testing ${shortCommit(search.testing)}: one of ${search.left} commits is the first bad one.`
            : 'The result is being stored.'}
        </Text>
      );
    case 'FOUND':
      return (
        <Badge color="green" miw="max-content">
          First bad commit found
        </Badge>
      );
    case 'UNCERTAIN':
      return (
        <Text size="sm">
          {`One of these ${search.left} commits is the first bad one. The others cannot be tested.`}
        </Text>
      );
    case 'FAILED':
      return (
        <Badge color="red" miw="max-content">
          Ended without a result
        </Badge>
      );
    case 'CANCELLED':
      return <Badge color="gray">Cancelled</Badge>;
  }
}

function FirstBad({ commit }: { commit: GitBisectionCommit }) {
  return (
    <Stack gap={2}>
      <Text size="sm" fw={700}>
        <UserText>{commit.subject}</UserText>
      </Text>
      <Text size="xs" c="dimmed">
        <UserText>{`${shortCommit(commit.sha)} · ${commit.author} · `}</UserText>
        <Age at={commit.authored} />
      </Text>
      {commit.reason && (
        <Text size="sm">
          <UserText>{commit.reason}</UserText>
        </Text>
      )}
      {commit.results.map(({ model, buildId, baseBuildId, state }) => (
        <Group key={model} gap="sm">
          <RouteLink to="/builds/$buildId" params={{ buildId }} size="sm">
            <UserText>{`Build of ${model}`}</UserText>
          </RouteLink>
          {state === 'DONE' && (
            <RouteLink
              to="/builds/$buildId/compare"
              params={{ buildId }}
              search={{ with: baseBuildId }}
              size="sm"
            >
              <UserText>{`What differs in ${model}`}</UserText>
            </RouteLink>
          )}
        </Group>
      ))}
    </Stack>
  );
}

const OUTCOMES = { GOOD: 'good', BAD: 'bad', SKIPPED: 'cannot be tested' };

function Tested({ commits }: { commits: readonly GitBisectionCommit[] }) {
  if (commits.length === 0) return null;
  return (
    <details>
      <Text component="summary" size="sm">{`${counted(commits.length, 'commit')} tested`}</Text>
      <List size="sm" type="ordered" mt="xs">
        {commits.map((commit) => (
          <List.Item key={commit.sha}>
            <UserText>
              {`${shortCommit(commit.sha)} ${commit.outcome ? OUTCOMES[commit.outcome] : ''}: ${commit.subject}`}
            </UserText>
            {commit.outcome === 'SKIPPED' && commit.reason && (
              <Text size="xs" c="dimmed">
                <UserText>{commit.reason}</UserText>
              </Text>
            )}
          </List.Item>
        ))}
      </List>
    </details>
  );
}

function Cancel({ activityId, number }: { activityId: string; number: number }) {
  const cancel = useCancelGitBisection(activityId);
  return (
    <Stack gap={4} align="start">
      <Button
        size="compact-sm"
        variant="default"
        aria-label={`Cancel search ${number}`}
        loading={cancel.isPending}
        onClick={() => {
          cancel.mutate(number);
        }}
      >
        Cancel
      </Button>
      {cancel.isError && (
        <ProblemAlert
          title="The search was not cancelled"
          error={cancel.error}
          onClose={cancel.reset}
        />
      )}
    </Stack>
  );
}
