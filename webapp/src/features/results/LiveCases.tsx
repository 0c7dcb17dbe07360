import { Group, Stack, Switch, Text } from '@mantine/core';
import { useState, type ReactNode } from 'react';
import type { ResultCase, ResultParameter } from '@/shared/api';
import { groupColumns } from '@/shared/lib/columns';
import { Loading, ProblemAlert } from '@/shared/ui';
import { CaseDrawer } from './CaseDrawer';
import { CaseTable } from './CaseTable';
import { useLiveCases } from './queries';

interface LiveCasesProps {
  buildId: string;
  parameters: readonly ResultParameter[];
  /** Whether the build is still running. */
  running: boolean;
  caseDetails?: (item: ResultCase) => ReactNode;
}

/** The finished cases of a running build, in the order in which they finished. */
export function LiveCases({ buildId, parameters, running, caseDetails }: LiveCasesProps) {
  const { total, error, pages } = useLiveCases(buildId, running);
  const [follow, setFollow] = useState(true);
  const [shown, setShown] = useState<ResultCase | null>(null);
  if (error) return <ProblemAlert title="The cases could not be read" error={error} />;
  if (total === undefined) return <Loading what="cases" />;
  if (total === 0) {
    return <Text c="dimmed">{running ? 'No cases have finished yet.' : 'No cases finished.'}</Text>;
  }
  return (
    <Stack gap="sm">
      {running && (
        <Group>
          <Switch
            label="Follow new cases"
            checked={follow}
            onChange={(event) => {
              setFollow(event.currentTarget.checked);
            }}
          />
        </Group>
      )}
      <CaseTable
        pages={pages}
        groups={groupColumns(parameters)}
        total={total}
        onCase={setShown}
        failures
        follow={running && follow}
      />
      <CaseDrawer
        item={shown}
        parameters={parameters}
        onClose={() => {
          setShown(null);
        }}
        {...(caseDetails && { details: caseDetails })}
      />
    </Stack>
  );
}
