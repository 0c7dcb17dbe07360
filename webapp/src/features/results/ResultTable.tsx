import { Stack, Text } from '@mantine/core';
import type { ResultCase, ResultParameter } from '@/shared/api';
import { formatCount, formatTime } from '@/shared/lib/format';
import { VERDICT_WORDS } from '@/shared/lib/verdicts';
import { Loading, ProblemAlert, UserText, useVirtualPages } from '@/shared/ui';
import { groupColumns, type ColumnGroup } from '@/shared/lib/columns';
import { differenceOf } from './difference';
import { CASES_PER_PAGE, useFetchCases, useFirstCases, type CaseFilter } from './queries';
import classes from './results.module.css';

const ROW_HEIGHT = 34;

interface ResultTableProps {
  buildId: string;
  parameters: readonly ResultParameter[];
  filter: CaseFilter;
  onCase: (item: ResultCase) => void;
}

/** The table view of a result, as the paper's Fig. 17(a): No, the inputs, ER, MR, PF, time. */
export function ResultTable({ buildId, parameters, filter, onCase }: ResultTableProps) {
  const first = useFirstCases(buildId, filter);
  if (first.isPending) return <Loading what="cases" />;
  if (!first.data) {
    return <ProblemAlert title="The cases could not be read" error={first.error} />;
  }
  if (first.data.total === 0) return <Text c="dimmed">No case is so.</Text>;
  return (
    <Rows
      // Another filter is another list, which begins at its top.
      key={JSON.stringify(filter)}
      buildId={buildId}
      groups={groupColumns(parameters)}
      filter={filter}
      total={first.data.total}
      onCase={onCase}
    />
  );
}

interface RowsProps {
  buildId: string;
  groups: ColumnGroup[];
  filter: CaseFilter;
  total: number;
  onCase: (item: ResultCase) => void;
}

function Rows({ buildId, groups, filter, total, onCase }: RowsProps) {
  const { scroller, rows, above, below, error } = useVirtualPages<ResultCase>({
    total,
    pageSize: CASES_PER_PAGE,
    rowHeight: ROW_HEIGHT,
    ...useFetchCases(buildId, filter),
  });
  const inputs = groups.reduce((sum, { columns }) => sum + columns.length, 0);
  return (
    <Stack gap="xs">
      {error && <ProblemAlert title="Some cases could not be read" error={error} />}
      <div ref={scroller} className={classes.scroller} tabIndex={0} role="group" aria-label="Cases">
        <table
          className={classes.cases}
          aria-label="Cases"
          aria-rowcount={total + 2}
          style={{ minWidth: `${30 + inputs * 8}rem` }}
        >
          <Columns inputs={inputs} />
          <Head groups={groups} />
          <tbody>
            {above > 0 && <Space height={above} />}
            {rows.map(({ index, item }) =>
              item ? (
                <CaseRow key={index} index={index} item={item} groups={groups} onCase={onCase} />
              ) : (
                <tr key={index} style={{ height: ROW_HEIGHT }} aria-hidden />
              ),
            )}
            {below > 0 && <Space height={below} />}
          </tbody>
        </table>
      </div>
      <Text size="sm" c="dimmed">
        {formatCount(total)} {total === 1 ? 'case' : 'cases'}
      </Text>
    </Stack>
  );
}

function Space({ height }: { height: number }) {
  return (
    <tr aria-hidden>
      <td className={classes.space} style={{ height }} />
    </tr>
  );
}

/** Fixed widths: columns must not jump while rows come and go. */
function Columns({ inputs }: { inputs: number }) {
  return (
    <colgroup>
      <col style={{ width: '4.5rem' }} />
      {Array.from({ length: inputs }, (_, index) => (
        <col key={index} />
      ))}
      <col style={{ width: '7rem' }} />
      <col style={{ width: '7rem' }} />
      <col style={{ width: '6rem' }} />
      <col style={{ width: '8.5rem' }} />
      <col style={{ width: '6.5rem' }} />
      <col style={{ width: '16rem' }} />
    </colgroup>
  );
}

function Head({ groups }: { groups: ColumnGroup[] }) {
  return (
    <thead>
      <tr>
        <th rowSpan={2}>No</th>
        {groups.map((group) => (
          <th key={group.type} colSpan={group.columns.length} scope="colgroup">
            {group.label}
          </th>
        ))}
        <th rowSpan={2}>
          <abbr title="Expected result">ER</abbr>
        </th>
        <th rowSpan={2}>
          <abbr title="Measured result">MR</abbr>
        </th>
        <th rowSpan={2}>
          <abbr title="Measured less expected">MR − ER</abbr>
        </th>
        <th rowSpan={2} className={classes.text}>
          <abbr title="Pass or fail">PF</abbr>
        </th>
        <th rowSpan={2}>Time (µs)</th>
        <th rowSpan={2} className={classes.text}>
          Message
        </th>
      </tr>
      <tr>
        {groups.flatMap((group) =>
          group.columns.map(({ parameter, index }) => (
            <th key={index}>
              <UserText>{parameter.name}</UserText>
            </th>
          )),
        )}
      </tr>
    </thead>
  );
}

interface CaseRowProps {
  index: number;
  item: ResultCase;
  groups: ColumnGroup[];
  onCase: (item: ResultCase) => void;
}

function CaseRow({ index, item, groups, onCase }: CaseRowProps) {
  const { label, sign } = VERDICT_WORDS[item.verdict];
  return (
    <tr data-verdict={item.verdict} aria-rowindex={index + 3} style={{ height: ROW_HEIGHT }}>
      <td>
        <button
          type="button"
          className={classes.open}
          aria-label={`Case ${item.no}`}
          onClick={() => {
            onCase(item);
          }}
        >
          {item.no}
        </button>
      </td>
      {groups.flatMap((group) =>
        group.columns.map((column) => (
          <td key={column.index} title={item.values[column.index]}>
            <UserText>{item.values[column.index] ?? ''}</UserText>
          </td>
        )),
      )}
      <td>
        <Outputs outputs={item.expected} />
      </td>
      <td>
        <Outputs outputs={item.actual} />
      </td>
      <td>{differenceOf(item.expected, item.actual) ?? ''}</td>
      <td className={classes.verdict}>
        <span aria-hidden>{sign}</span> {label}
      </td>
      <td>{formatTime(item.processingTimeUs)}</td>
      <td className={classes.message} title={item.message ?? undefined}>
        {item.message && <UserText>{item.message}</UserText>}
      </td>
    </tr>
  );
}

/** A single output needs no name; several are told apart by theirs. */
function Outputs({ outputs }: { outputs: Record<string, string> | null | undefined }) {
  const entries = Object.entries(outputs ?? {});
  if (entries.length === 0) return '–';
  return (
    <UserText>
      {entries
        .map(([name, value]) => (entries.length === 1 ? value : `${name} = ${value}`))
        .join(', ')}
    </UserText>
  );
}
