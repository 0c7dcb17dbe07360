import { Stack, Text } from '@mantine/core';
import { Loading, ProblemAlert, RouteLink, Section } from '@/shared/ui';
import { Bisections } from './Bisections';
import { BranchTable } from './BranchTable';
import { GitSettings } from './GitSettings';
import { useGitSource } from './queries';
import { nounOf } from './requestNouns';
import { Requests } from './Requests';

interface GitTabProps {
  activityId: string;
  /** The pull or merge request whose commits are shown; absent for the branch. */
  request?: number | undefined;
  /** From 0. */
  page: number;
  onPage: (page: number) => void;
  /** The commit of a link in a status. */
  marked?: string | undefined;
  /** Whether the user may let commits be built, also those of a request. */
  mayBuild: boolean;
}

/** The commits and requests of an activity's branch, and the settings of its Git source. */
export function GitTab({ activityId, request, page, onPage, marked, mayBuild }: GitTabProps) {
  const source = useGitSource(activityId);
  if (source.isPending) return <Loading what="the Git source" />;
  if (source.data === undefined) {
    return <ProblemAlert title="The Git source could not be read" error={source.error} />;
  }
  return (
    <Stack gap="xl">
      {source.data ? (
        <>
          <Section
            title={
              request === undefined
                ? 'Commits'
                : `Commits of ${nounOf(source.data.forge).toLowerCase()} ${request}`
            }
            actions={
              request !== undefined && (
                <RouteLink
                  to="/activities/$activityId"
                  params={{ activityId }}
                  search={{ tab: 'commits' }}
                  size="sm"
                >
                  Commits of the branch
                </RouteLink>
              )
            }
          >
            <BranchTable
              activityId={activityId}
              request={request}
              page={page}
              onPage={onPage}
              marked={marked}
              mayBuild={mayBuild}
            />
          </Section>
          {request === undefined && <Bisections activityId={activityId} mayBuild={mayBuild} />}
          <Requests activityId={activityId} forge={source.data.forge} mayBuild={mayBuild} />
        </>
      ) : (
        <Text c="dimmed">
          The files of this activity were uploaded. With a Git source they come from a branch, and
          each commit is tested and compared with the one before.
        </Text>
      )}
      <Section title="Git source">
        <GitSettings activityId={activityId} source={source.data} />
      </Section>
    </Stack>
  );
}
