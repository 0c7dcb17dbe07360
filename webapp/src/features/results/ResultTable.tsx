import { Stack, Table, Text } from '@mantine/core';
import type { ResultParameter, ResultCase, Verdict } from '@/shared/api';
import { formatTime } from '@/shared/lib/format';
import { Loading, Pager, ProblemAlert, ScrollTable, UserText } from '@/shared/ui';
import { groupColumns, type ColumnGroup } from './columns';
import { CASES_PER_PAGE, useResultCases } from './queries';
import classes from './results.module.css';
import { VERDICT_WORDS } from './verdicts';

interface ResultTableProps {
  buildId: string;
  parameters: readonly ResultParameter[];
  page: number;
  onPage: (page: number) => void;
  verdict?: Verdict;
}

/** The table view of a result, as the paper's Fig. 17(a): No, the inputs, ER, MR, PF, time. */
export function ResultTable({ buildId, parameters, page, onPage, verdict }: ResultTableProps) {
  const cases = useResultCases(buildId, page, verdict);
  if (cases.isPending) return <Loading what="cases" />;
  if (!cases.data) {
    return <ProblemAlert title="The cases could not be read" error={cases.error} />;
  }
  const { items, total } = cases.data;
  if (total === 0) return <Text c="dimmed">No case has this verdict.</Text>;
  const groups = groupColumns(parameters);
  const withMessages = items.some((item) => item.message);
  return (
    <Stack gap="xs">
      <ScrollTable
        label="Cases"
        minWidth={640}
        withColumnBorders
        verticalSpacing={5}
        className={classes.cases}
      >
        <Head groups={groups} withMessages={withMessages} />
        <Table.Tbody aria-busy={cases.isPlaceholderData}>
          {items.map((item) => (
            <CaseRow key={item.no} item={item} groups={groups} withMessages={withMessages} />
          ))}
        </Table.Tbody>
      </ScrollTable>
      <Pager
        label="Pages of cases"
        page={page}
        size={CASES_PER_PAGE}
        total={total}
        onPage={onPage}
      />
    </Stack>
  );
}

function Head({ groups, withMessages }: { groups: ColumnGroup[]; withMessages: boolean }) {
  return (
    <Table.Thead>
      <Table.Tr>
        <Table.Th rowSpan={2}>No</Table.Th>
        {groups.map((group) => (
          <Table.Th key={group.type} colSpan={group.columns.length} scope="colgroup" ta="center">
            {group.label}
          </Table.Th>
        ))}
        <Table.Th rowSpan={2}>
          <abbr title="Expected result">ER</abbr>
        </Table.Th>
        <Table.Th rowSpan={2}>
          <abbr title="Measured result">MR</abbr>
        </Table.Th>
        <Table.Th rowSpan={2} className={classes.text}>
          <abbr title="Pass or fail">PF</abbr>
        </Table.Th>
        <Table.Th rowSpan={2}>Time (µs)</Table.Th>
        {withMessages && (
          <Table.Th rowSpan={2} className={classes.text}>
            Message
          </Table.Th>
        )}
      </Table.Tr>
      <Table.Tr>
        {groups.flatMap((group) =>
          group.columns.map(({ parameter, index }) => (
            <Table.Th key={index}>
              <UserText>{parameter.name}</UserText>
            </Table.Th>
          )),
        )}
      </Table.Tr>
    </Table.Thead>
  );
}

function CaseRow({
  item,
  groups,
  withMessages,
}: {
  item: ResultCase;
  groups: ColumnGroup[];
  withMessages: boolean;
}) {
  const { label, sign } = VERDICT_WORDS[item.verdict];
  return (
    <Table.Tr data-verdict={item.verdict}>
      <Table.Td>{item.no}</Table.Td>
      {groups.flatMap((group) =>
        group.columns.map(({ index }) => (
          <Table.Td key={index}>
            <UserText>{item.values[index] ?? ''}</UserText>
          </Table.Td>
        )),
      )}
      <Table.Td>
        <Outputs outputs={item.expected} />
      </Table.Td>
      <Table.Td>
        <Outputs outputs={item.actual} />
      </Table.Td>
      <Table.Td className={classes.verdict}>
        <span aria-hidden>{sign}</span> {label}
      </Table.Td>
      <Table.Td>{formatTime(item.processingTimeUs)}</Table.Td>
      {withMessages && (
        <Table.Td className={classes.message}>
          {item.message && <UserText>{item.message}</UserText>}
        </Table.Td>
      )}
    </Table.Tr>
  );
}

/** A single output needs no name; several are told apart by theirs. */
function Outputs({ outputs }: { outputs: Record<string, string> | null | undefined }) {
  const entries = Object.entries(outputs ?? {});
  if (entries.length === 0) return '–';
  return entries.map(([name, value]) => (
    <div key={name}>
      <UserText>{entries.length === 1 ? value : `${name} = ${value}`}</UserText>
    </div>
  ));
}
