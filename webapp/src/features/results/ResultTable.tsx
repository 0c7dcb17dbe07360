import { Text } from '@mantine/core';
import type { ResultCase, ResultParameter } from '@/shared/api';
import { groupColumns } from '@/shared/lib/columns';
import { Loading, ProblemAlert } from '@/shared/ui';
import { CaseTable } from './CaseTable';
import { useFetchCases, useFirstCases, type CaseFilter } from './queries';

interface ResultTableProps {
  buildId: string;
  parameters: readonly ResultParameter[];
  filter: CaseFilter;
  onCase: (item: ResultCase) => void;
}

/** The table view of a result, as the paper's Fig. 17(a). */
export function ResultTable({ buildId, parameters, filter, onCase }: ResultTableProps) {
  const first = useFirstCases(buildId, filter);
  const pages = useFetchCases(buildId, filter);
  if (first.isPending) return <Loading what="cases" />;
  if (!first.data) {
    return <ProblemAlert title="The cases could not be read" error={first.error} />;
  }
  if (first.data.total === 0) return <Text c="dimmed">No case is so.</Text>;
  return (
    <CaseTable
      // Another filter is another list, which begins at its top.
      key={JSON.stringify(filter)}
      pages={pages}
      groups={groupColumns(parameters)}
      total={first.data.total}
      onCase={onCase}
    />
  );
}
