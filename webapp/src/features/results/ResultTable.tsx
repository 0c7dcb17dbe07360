import { Group, Switch, Text } from '@mantine/core';
import { useState } from 'react';
import type { ResultCase, ResultParameter } from '@/shared/api';
import { groupColumns, type ColumnGroup } from '@/shared/lib/columns';
import { Loading, ProblemAlert, UserText } from '@/shared/ui';
import { CaseTable } from './CaseTable';
import {
  CASES_PER_PAGE,
  useFetchCases,
  useFirstCases,
  useStatistics,
  type CaseFilter,
} from './queries';

interface ResultTableProps {
  buildId: string;
  parameters: readonly ResultParameter[];
  filter: CaseFilter;
  /** Whether any case of the result did not pass. */
  failures: boolean;
  onCase: (item: ResultCase) => void;
}

/** The table of a result, as in the paper's Fig. 17(a). Constant parameters can be hidden. */
export function ResultTable({ buildId, parameters, filter, failures, onCase }: ResultTableProps) {
  const first = useFirstCases(buildId, filter);
  const pages = useFetchCases(buildId, filter);
  const constants = useConstants(buildId, parameters, first.data);
  const [showAll, setShowAll] = useState(false);
  if (first.isPending) return <Loading what="cases" />;
  if (!first.data) {
    return <ProblemAlert title="The cases could not be read" error={first.error} />;
  }
  if (first.data.total === 0) return <Text c="dimmed">No matching cases.</Text>;
  const groups = groupColumns(parameters);
  return (
    <>
      {constants.size > 0 && (
        <Group justify="space-between" gap="sm">
          <Text size="sm">
            Same in all cases:{' '}
            <UserText>
              {[...constants].map(([name, value]) => `${name} = ${value}`).join(', ')}
            </UserText>
          </Text>
          <Switch
            label="Show constant parameters"
            checked={showAll}
            onChange={(event) => {
              setShowAll(event.currentTarget.checked);
            }}
          />
        </Group>
      )}
      <CaseTable
        // A new filter starts a new list at its first row.
        key={JSON.stringify(filter)}
        pages={pages}
        groups={showAll ? groups : withoutConstants(groups, constants)}
        total={first.data.total}
        failures={failures}
        onCase={onCase}
      />
    </>
  );
}

/** Parameters with the same value in all listed cases, with that value. */
function useConstants(
  buildId: string,
  parameters: readonly ResultParameter[],
  first: { items: ResultCase[]; total: number } | undefined,
): ReadonlyMap<string, string> {
  const total = first?.total ?? 0;
  const complete = total <= CASES_PER_PAGE;
  const statistics = useStatistics(buildId, !complete);
  const constants = new Map<string, string>();
  if (total < 2) return constants;
  parameters.forEach(({ name }, index) => {
    const values = complete
      ? new Set(first?.items.map((item) => item.values[index] ?? ''))
      : new Set(valuesOf(statistics.data, name));
    const [value] = values;
    if (values.size === 1 && value !== undefined) constants.set(name, value);
  });
  return constants;
}

function valuesOf(statistics: ReturnType<typeof useStatistics>['data'], name: string): string[] {
  const parameter = statistics?.parameters.find((known) => known.name === name);
  // Statistics that omit values do not show whether a parameter is constant.
  return parameter?.leftOut === 0 ? parameter.values.map(({ value }) => value) : [];
}

function withoutConstants(
  groups: readonly ColumnGroup[],
  constants: ReadonlyMap<string, string>,
): ColumnGroup[] {
  return groups
    .map((group) => ({
      ...group,
      columns: group.columns.filter(({ parameter }) => !constants.has(parameter.name)),
    }))
    .filter(({ columns }) => columns.length > 0);
}
