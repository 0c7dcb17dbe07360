import { Button, Stack } from '@mantine/core';
import type { GitCommit } from '@/shared/api';
import { shortCommit } from '@/shared/lib/commits';
import { ProblemAlert } from '@/shared/ui';
import { useBeginGitBisection, useGitBisections } from './queries';

/** Whether commits before it were not built, of which one may have brought what differs. */
export function hasUnknownOrigin({ request, state, replaced, notBuilt, cells }: GitCommit) {
  return (
    request === 0 &&
    state === 'DONE' &&
    !replaced &&
    notBuilt > 0 &&
    cells.some(({ differing }) => differing !== undefined && differing > 0)
  );
}

/** Asks for the commit that brought what differs, unless a search of the branch runs. */
export function BeginBisection({ activityId, commit }: { activityId: string; commit: GitCommit }) {
  const bisections = useGitBisections(activityId);
  const begin = useBeginGitBisection(activityId);
  const searches = bisections.data?.items ?? [];
  const isKnown = searches.some(({ bad, state }) => bad === commit.sha && state === 'FOUND');
  if (!bisections.data || isKnown) return null;
  return (
    <Stack gap={4} align="start" mt={4}>
      <Button
        size="compact-sm"
        variant="default"
        aria-label={`Find the first bad commit up to ${shortCommit(commit.sha)}`}
        loading={begin.isPending}
        disabled={searches.some(({ state }) => state === 'RUNNING')}
        onClick={() => {
          begin.mutate(commit.sha);
        }}
      >
        Find the first bad commit
      </Button>
      {begin.isError && (
        <ProblemAlert title="The search did not begin" error={begin.error} onClose={begin.reset} />
      )}
    </Stack>
  );
}
