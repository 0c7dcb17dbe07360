import { Stack, Text } from '@mantine/core';
import { useEffect } from 'react';
import type { QueryKey } from '@tanstack/react-query';
import type { ResultCase } from '@/shared/api';
import { formatCount, formatTime } from '@/shared/lib/format';
import { VERDICT_WORDS } from '@/shared/lib/verdicts';
import { ProblemAlert, UserText, useVirtualPages } from '@/shared/ui';
import type { ColumnGroup } from '@/shared/lib/columns';
import { differenceOf } from './difference';
import { CASES_PER_PAGE } from './queries';
import classes from './results.module.css';

const ROW_HEIGHT = 34;

/** Where the rows come from, a page at a time. */
export interface CasePages {
  queryKey: QueryKey;
  fetchPage: (page: number, signal?: AbortSignal) => Promise<{ items: ResultCase[] }>;
}

interface CaseTableProps {
  pages: CasePages;
  groups: ColumnGroup[];
  total: number;
  onCase: (item: ResultCase) => void;
  /** Whether the last row stays in sight while the table grows. */
  follow?: boolean;
}

/** Cases in the columns of the paper's Fig. 17(a): No, the inputs, ER, MR, PF, time. */
export function CaseTable({ pages, groups, total, onCase, follow = false }: CaseTableProps) {
  const { scroller, rows, above, below, error, scrollTo } = useVirtualPages<ResultCase>({
    total,
    pageSize: CASES_PER_PAGE,
    rowHeight: ROW_HEIGHT,
    ...pages,
  });
  useEffect(() => {
    if (follow && total > 0) scrollTo(total - 1);
    // Only another total moves the table; the virtualiser is another object with each drawing.
    // eslint-disable-next-line react-hooks/exhaustive-deps
  }, [follow, total]);
  const inputs = widthsOf(groups);
  return (
    <Stack gap="xs">
      {error && <ProblemAlert title="Some cases could not be read" error={error} />}
      <div ref={scroller} className={classes.scroller} tabIndex={0} role="group" aria-label="Cases">
        <table
          className={classes.cases}
          aria-label="Cases"
          aria-rowcount={total + 2}
          style={{ minWidth: `${leastWidth(inputs)}rem` }}
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

/** Fixed widths, in rem: columns must not jump while rows come and go. The message takes what is left. */
const WIDTHS = { no: 4, expected: 6, actual: 6, difference: 5.5, verdict: 8, time: 6.5 } as const;
const LEAST_MESSAGE = 10;

/** What a heading of so many characters takes, in bold. */
function widthOfText(text: string): number {
  return 1.8 + 0.66 * text.length;
}

/** Each input as wide as its name, within reason, and those of a kind together as wide as theirs. */
function widthsOf(groups: readonly ColumnGroup[]): number[] {
  return groups.flatMap(({ label, columns }) => {
    const least = widthOfText(label) / columns.length;
    return columns.map(({ parameter }) =>
      Math.min(18, Math.max(6, least, widthOfText(parameter.name))),
    );
  });
}

function leastWidth(inputs: readonly number[]): number {
  return [...Object.values(WIDTHS), ...inputs].reduce((sum, width) => sum + width, LEAST_MESSAGE);
}

function Columns({ inputs }: { inputs: readonly number[] }) {
  const { no, ...others } = WIDTHS;
  return (
    <colgroup>
      <col style={{ width: `${no}rem` }} />
      {inputs.map((width, index) => (
        <col key={index} style={{ width: `${width}rem` }} />
      ))}
      {Object.entries(others).map(([name, width]) => (
        <col key={name} style={{ width: `${width}rem` }} />
      ))}
      <col />
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
            <th key={index} title={parameter.name}>
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
      <td title={textOf(item.expected)}>
        <UserText>{textOf(item.expected)}</UserText>
      </td>
      <td title={textOf(item.actual)}>
        <UserText>{textOf(item.actual)}</UserText>
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
function textOf(outputs: Record<string, string> | null | undefined): string {
  const entries = Object.entries(outputs ?? {});
  if (entries.length === 0) return '–';
  return entries
    .map(([name, value]) => (entries.length === 1 ? value : `${name} = ${value}`))
    .join(', ');
}
