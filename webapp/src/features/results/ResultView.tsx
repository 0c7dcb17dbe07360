import { Anchor, Group, Stack } from '@mantine/core';
import type { ReactNode } from 'react';
import type { ResultCase } from '@/shared/api';
import { Loading, ProblemAlert, Section } from '@/shared/ui';
import { CaseDrawer } from './CaseDrawer';
import type { Trajectory } from './CaseFacts';
import { CaseFilters } from './CaseFilters';
import { useCase, useFirstCases, useResult, type CaseFilter } from './queries';
import { RelationCounts } from './RelationCounts';
import { ResultAnswer } from './ResultAnswer';
import { ResultProvenance } from './ResultProvenance';
import { ResultSummary } from './ResultSummary';
import { ResultTable } from './ResultTable';
import { Suspicions } from './Suspicions';

interface ResultViewProps {
  buildId: string;
  filter: CaseFilter;
  onFilter: (filter: CaseFilter) => void;
  caseDetails?: (item: ResultCase) => ReactNode;
  /** A link to the moment when a trajectory condition was violated. */
  momentLink?: (item: ResultCase, trajectory: Trajectory) => ReactNode;
  /** Number of the selected case, if any. */
  caseNo?: number | undefined;
  onCase: (no: number | undefined) => void;
  /** The replay of a case in small. */
  replay?: ((no: number) => ReactNode) | undefined;
  /** Why cases fail, shown above the table. */
  cause?: ReactNode;
}

/** The summary of a result and the table of its cases. */
export function ResultView({
  buildId,
  filter,
  onFilter,
  caseDetails,
  momentLink,
  caseNo,
  onCase,
  replay,
  cause,
}: ResultViewProps) {
  const result = useResult(buildId);
  const shown = useCase(buildId, caseNo);
  // Requested together with the summary, so that the table is shown earlier.
  useFirstCases(buildId, filter);
  if (result.isPending) return <Loading what="the result" />;
  if (!result.data) {
    return <ProblemAlert title="The result could not be read" error={result.error} />;
  }
  const { summary, parameters, suspicions, relations, provenance } = result.data;
  return (
    <Stack gap="lg">
      <Section title="Result" actions={<Downloads buildId={buildId} />}>
        <Suspicions reasons={suspicions} />
        <ResultAnswer buildId={buildId} summary={summary} replay={replay} onCase={onCase} />
        <ResultSummary summary={summary} />
        <RelationCounts relations={relations} />
      </Section>
      {cause}
      <Section title="Cases">
        <CaseFilters
          summary={summary}
          parameters={parameters}
          filter={filter}
          onFilter={onFilter}
        />
        <ResultTable
          buildId={buildId}
          parameters={parameters}
          filter={filter}
          failures={summary.pass < summary.total}
          onCase={({ no }) => {
            onCase(no);
          }}
        />
      </Section>
      <ResultProvenance provenance={provenance} />
      <CaseDrawer
        item={caseNo === undefined ? null : (shown.data ?? null)}
        parameters={parameters}
        onClose={() => {
          onCase(undefined);
        }}
        momentLink={momentLink}
        {...(caseDetails && { details: caseDetails })}
      />
    </Stack>
  );
}

function Downloads({ buildId }: { buildId: string }) {
  const result = `/api/v1/builds/${encodeURIComponent(buildId)}/result`;
  const files = [
    { label: 'Result XML', path: 'document', name: `result-${buildId}.xml` },
    { label: 'JUnit XML', path: 'junit', name: `junit-${buildId}.xml` },
    { label: 'CSV', path: 'cases.csv', name: `result-${buildId}.csv` },
    { label: 'HTML report', path: 'report', name: `report-${buildId}.html` },
  ];
  return (
    <Group gap="md">
      {files.map(({ label, path, name }) => (
        <Anchor key={path} size="sm" href={`${result}/${path}`} download={name}>
          {label}
        </Anchor>
      ))}
    </Group>
  );
}
