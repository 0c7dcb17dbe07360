import { Stack, Text } from '@mantine/core';
import { Loading, ProblemAlert, Section } from '@/shared/ui';
import { BranchTable } from './BranchTable';
import { GitSettings } from './GitSettings';
import { useGitSource } from './queries';

interface GitTabProps {
  activityId: string;
  /** From 0. */
  page: number;
  onPage: (page: number) => void;
  /** The commit of a link in a status. */
  marked?: string | undefined;
}

/** The commits of an activity's branch, and the settings of its Git source. */
export function GitTab({ activityId, page, onPage, marked }: GitTabProps) {
  const source = useGitSource(activityId);
  if (source.isPending) return <Loading what="the Git source" />;
  if (source.data === undefined) {
    return <ProblemAlert title="The Git source could not be read" error={source.error} />;
  }
  return (
    <Stack gap="xl">
      {source.data ? (
        <Section title="Commits">
          <BranchTable activityId={activityId} page={page} onPage={onPage} marked={marked} />
        </Section>
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
