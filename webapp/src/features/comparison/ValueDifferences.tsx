import { List, Stack, Table, Text } from '@mantine/core';
import { useState } from 'react';
import { plural } from '@/shared/lib/format';
import { Loading, Pager, ProblemAlert, ScrollTable, Section, UserText } from '@/shared/ui';
import { DifferenceTable, type ShownCase } from './DifferenceTable';
import { GroupTable } from './GroupTable';
import {
  DIFFERENCES_PER_PAGE,
  useDifferences,
  useNotComparable,
  useValueComparison,
  type Part,
} from './queries';

export type { ShownCase };

interface ValueDifferencesProps {
  buildId: string;
  other: string;
  /** Index of the group whose cases are shown. */
  group: number | undefined;
  /** From 0. */
  page: number;
  onGroup: (group: number | undefined) => void;
  onPage: (page: number) => void;
  onReplays: (shown: ShownCase) => void;
}

/** What two results do differently, by their values. */
export function ValueDifferences({ buildId, other, ...shown }: ValueDifferencesProps) {
  const comparison = useValueComparison(buildId, other);
  if (comparison.isPending) return <Loading what="the values" />;
  if (!comparison.data) {
    return <ProblemAlert title="The values could not be compared" error={comparison.error} />;
  }
  const { data } = comparison;
  const { group, page, onGroup, onPage, onReplays } = shown;
  const hidden = data.groupCount - data.groups.length;
  return (
    <Stack gap="xl">
      <Section title={`Differences: ${data.differences}`}>
        <Text>
          {plural(data.cases, 'case')} compared by their values, {data.differingCases} with
          differences.
        </Text>
        <Text size="sm" c="dimmed">
          Each build ran once, so a component that depends on chance may differ, too. ./sitaf
          compare confirms differences by further runs.
        </Text>
        {data.otherTools.length > 0 && (
          <Stack gap={4}>
            <Text>The builds did not use the same packages and tools:</Text>
            <List size="sm">
              {data.otherTools.map((change) => (
                <List.Item key={change}>
                  <UserText>{change}</UserText>
                </List.Item>
              ))}
            </List>
          </Stack>
        )}
        {hidden > 0 && <Text c="dimmed">{plural(hidden, 'smaller group')} not shown.</Text>}
        <GroupTable groups={data.groups} selected={group} onSelect={onGroup} />
        {group !== undefined && (
          <CasesOfGroup
            key={group}
            buildId={buildId}
            other={other}
            group={group}
            parameters={data.parameters}
            page={page}
            onPage={onPage}
            onReplays={onReplays}
          />
        )}
      </Section>
      <PartOf
        buildId={buildId}
        other={other}
        part="lastBits"
        title={`Last bits only: ${data.lastBits}`}
        count={data.lastBits}
        parameters={data.parameters}
        onReplays={onReplays}
      />
      <NotComparable buildId={buildId} other={other} count={data.notComparable} />
    </Stack>
  );
}

function CasesOfGroup({
  buildId,
  other,
  group,
  parameters,
  page,
  onPage,
  onReplays,
}: {
  buildId: string;
  other: string;
  group: number;
  parameters: readonly string[];
  page: number;
  onPage: (page: number) => void;
  onReplays: (shown: ShownCase) => void;
}) {
  const cases = useDifferences(buildId, other, { group }, page);
  if (cases.isPending) return <Loading what="the cases" />;
  if (!cases.data) {
    return <ProblemAlert title="The cases could not be read" error={cases.error} />;
  }
  return (
    <>
      <DifferenceTable
        label="Cases of the group"
        items={cases.data.items}
        parameters={parameters}
        onReplays={onReplays}
      />
      <Pager
        label="Pages of cases"
        page={page}
        size={DIFFERENCES_PER_PAGE}
        total={cases.data.total}
        onPage={onPage}
      />
    </>
  );
}

function PartOf({
  buildId,
  other,
  part,
  title,
  count,
  parameters,
  onReplays,
}: {
  buildId: string;
  other: string;
  part: Part;
  title: string;
  count: number;
  parameters: readonly string[];
  onReplays: (shown: ShownCase) => void;
}) {
  const [page, setPage] = useState(0);
  const found = useDifferences(buildId, other, { part }, page);
  if (count === 0) return null;
  return (
    <Section title={title}>
      <Text size="sm" c="dimmed">
        Numbers that differ by at most 4 units in the last place, which do not count.
      </Text>
      {found.data && (
        <DifferenceTable
          label={title}
          items={found.data.items}
          parameters={parameters}
          onReplays={onReplays}
        />
      )}
      <Pager
        label="Pages of last bits"
        page={page}
        size={DIFFERENCES_PER_PAGE}
        total={count}
        onPage={setPage}
      />
    </Section>
  );
}

function NotComparable({
  buildId,
  other,
  count,
}: {
  buildId: string;
  other: string;
  count: number;
}) {
  const [page, setPage] = useState(0);
  const found = useNotComparable(buildId, other, page);
  if (count === 0) return null;
  return (
    <Section title={`Not comparable: ${count}`}>
      {found.data && (
        <ScrollTable label="Not comparable" minWidth={480}>
          <Table.Thead>
            <Table.Tr>
              <Table.Th>Case</Table.Th>
              <Table.Th>Output</Table.Th>
              <Table.Th>Reason</Table.Th>
            </Table.Tr>
          </Table.Thead>
          <Table.Tbody>
            {found.data.items.map(({ no, output, reason }, index) => (
              <Table.Tr key={index}>
                <Table.Td>{no === 0 ? 'all' : no}</Table.Td>
                <Table.Td>{output === '' ? '–' : <UserText>{output}</UserText>}</Table.Td>
                <Table.Td>
                  <UserText>{reason}</UserText>
                </Table.Td>
              </Table.Tr>
            ))}
          </Table.Tbody>
        </ScrollTable>
      )}
      <Pager
        label="Pages of what is not comparable"
        page={page}
        size={DIFFERENCES_PER_PAGE}
        total={count}
        onPage={setPage}
      />
    </Section>
  );
}
