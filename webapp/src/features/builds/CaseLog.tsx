import { Stack, Text, Title } from '@mantine/core';
import { visible } from '@/shared/lib/visible';
import { Loading, ProblemAlert } from '@/shared/ui';
import classes from './builds.module.css';
import { useCaseLog } from './queries';

/** The output of the component in one case, shown as plain text. */
export function CaseLog({ buildId, no }: { buildId: string; no: number }) {
  const log = useCaseLog(buildId, no);
  return (
    <Stack gap="xs" component="section" aria-label={`Log of case ${no}`}>
      <Title order={3} size="h5">
        Log of the case
      </Title>
      {log.isPending ? (
        <Loading what="the log" />
      ) : log.data === undefined ? (
        <ProblemAlert title="The log could not be read" error={log.error} />
      ) : log.data === '' ? (
        <Text size="sm" c="dimmed">
          No output.
        </Text>
      ) : (
        <pre className={classes.log} tabIndex={0} data-case>
          {visible(log.data)}
        </pre>
      )}
    </Stack>
  );
}
