import { Stack, Text } from '@mantine/core';
import { useEffect, useState } from 'react';
import type { QueryKey } from '@tanstack/react-query';
import type { ResultCase } from '@/shared/api';
import { formatCount, formatTime, plural } from '@/shared/lib/format';
import { VERDICT_LABELS } from '@/shared/lib/verdicts';
import { ProblemAlert, UserText, useVirtualPages } from '@/shared/ui';
import type { ColumnGroup } from '@/shared/lib/columns';
import { differenceOf } from './difference';
import { CASES_PER_PAGE } from './queries';
import classes from './results.module.css';

const ROW_HEIGHT = 34;

/** The source of the rows, page by page. */
export interface CasePages {
  queryKey: QueryKey;
  fetchPage: (page: number, signal?: AbortSignal) => Promise<{ items: ResultCase[] }>;
}

interface CaseTableProps {
  pages: CasePages;
  groups: ColumnGroup[];
  total: number;
  onCase: (item: ResultCase) => void;
  /** Whether any case may have failed; otherwise there are no messages and no differences. */
  failures: boolean;
  /** Whether the table scrolls to the last row while it grows. */
  follow?: boolean;
}

/**
 * The cases with the data of the paper's Fig. 17(a). The verdict and the message come first, so that
 * they are visible however many parameters and outputs there are.
 */
export function CaseTable({
  pages,
  groups,
  total,
  onCase,
  failures,
  follow = false,
}: CaseTableProps) {
  const { scroller, rows, above, below, error, scrollTo } = useVirtualPages<ResultCase>({
    total,
    pageSize: CASES_PER_PAGE,
    rowHeight: ROW_HEIGHT,
    ...pages,
  });
  useEffect(() => {
    if (follow && total > 0) scrollTo(total - 1);
    // The virtualizer is a new object in each render; only a new total moves the table.
    // eslint-disable-next-line react-hooks/exhaustive-deps
  }, [follow, total]);
  const outputs = useOutputs(rows.flatMap(({ item }) => item ?? []));
  const sequences = useSequences(rows.some(({ item }) => item && item.steps.length > 0));
  const columns: Columns = { groups, outputs, failures, sequences };
  const widths = widthsOf(columns);
  return (
    <Stack gap="xs">
      {error && <ProblemAlert title="Some cases could not be read" error={error} />}
      <div ref={scroller} className={classes.scroller} tabIndex={0} role="group" aria-label="Cases">
        <table
          className={classes.cases}
          aria-label="Cases"
          aria-rowcount={total + 2}
          style={{ minWidth: `${widths.reduce((sum, width) => sum + width, 0)}rem` }}
        >
          <colgroup>
            {widths.map((width, index) => (
              <col key={index} style={{ width: `${width}rem` }} />
            ))}
          </colgroup>
          <Head {...columns} />
          <tbody>
            {above > 0 && <Space height={above} />}
            {rows.map(({ index, item }) =>
              item ? (
                <CaseRow key={index} index={index} item={item} columns={columns} onCase={onCase} />
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

interface Columns {
  groups: ColumnGroup[];
  outputs: readonly string[];
  failures: boolean;
  /** Whether the cases are sequences of steps. */
  sequences: boolean;
}

/** Whether a case seen so far is a sequence. */
function useSequences(seen: boolean): boolean {
  const [known, setKnown] = useState(seen);
  if (seen && !known) setKnown(true);
  return known || seen;
}

/** The outputs of all cases seen so far. */
function useOutputs(items: readonly ResultCase[]): readonly string[] {
  const [known, setKnown] = useState<readonly string[]>([]);
  const names = items.flatMap(({ expected, actual }) => [
    ...Object.keys(expected ?? {}),
    ...Object.keys(actual ?? {}),
  ]);
  const missing = [...new Set(names)].filter((name) => !known.includes(name));
  if (missing.length > 0) setKnown([...known, ...missing]);
  return known;
}

function Space({ height }: { height: number }) {
  return (
    <tr aria-hidden>
      <td className={classes.space} style={{ height }} />
    </tr>
  );
}

/** Widths in rem. They are fixed, so that columns do not move while rows are loaded. */
const WIDTHS = { no: 3.5, verdict: 8.5, message: 14, steps: 24, value: 5, time: 8.5 } as const;
/** Maximum width of a column. */
const MAX_WIDTH = 18;

function widthsOf({ groups, outputs, failures, sequences }: Columns): number[] {
  const inputs = groups.flatMap(({ label, columns }) => {
    const least = widthOfText(longestWord(label)) / columns.length;
    return columns.map(({ parameter }) => columnWidth(parameter.name, least));
  });
  return [
    WIDTHS.no,
    WIDTHS.verdict,
    ...(failures ? [WIDTHS.message] : []),
    ...(sequences ? [WIDTHS.steps] : []),
    ...inputs,
    ...outputGroups(failures).flatMap((label) => {
      const least = widthOfText(longestWord(label)) / outputs.length;
      return outputs.map((name) => columnWidth(name, least));
    }),
    WIDTHS.time,
  ];
}

function columnWidth(name: string, least: number): number {
  return Math.min(MAX_WIDTH, Math.max(WIDTHS.value, least, widthOfText(name)));
}

/** The width of a heading. */
function widthOfText(text: string): number {
  return 1.5 + 0.56 * text.length;
}

/** Headings of groups wrap at spaces. */
function longestWord(text: string): string {
  return text.split(' ').reduce((longest, word) => (word.length > longest.length ? word : longest));
}

function outputGroups(failures: boolean): string[] {
  return ['Expected', 'Actual', ...(failures ? ['Actual − expected'] : [])];
}

function Head({ groups, outputs, failures, sequences }: Columns) {
  const results = outputGroups(failures);
  return (
    <thead>
      <tr>
        <th rowSpan={2} className={classes.no}>
          No
        </th>
        <th rowSpan={2} className={classes.text}>
          Verdict
        </th>
        {failures && (
          <th rowSpan={2} className={classes.text}>
            Message
          </th>
        )}
        {sequences && (
          <th rowSpan={2} className={classes.text}>
            Steps
          </th>
        )}
        {groups.map((group) => (
          <th key={group.type} colSpan={group.columns.length} scope="colgroup">
            {group.label}
          </th>
        ))}
        {outputs.length > 0 &&
          results.map((label) => (
            <th key={label} colSpan={outputs.length} scope="colgroup">
              {label}
            </th>
          ))}
        <th rowSpan={2}>Time</th>
      </tr>
      <tr>
        {groups.flatMap((group) =>
          group.columns.map(({ parameter, index }) => (
            <th key={index} title={parameter.name}>
              <UserText>{parameter.name}</UserText>
            </th>
          )),
        )}
        {results.flatMap((label) =>
          outputs.map((name) => (
            <th key={`${label} ${name}`} title={name}>
              <UserText>{name}</UserText>
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
  columns: Columns;
  onCase: (item: ResultCase) => void;
}

function CaseRow({
  index,
  item,
  columns: { groups, outputs, failures, sequences },
  onCase,
}: CaseRowProps) {
  const { label, sign } = VERDICT_LABELS[item.verdict];
  return (
    <tr data-verdict={item.verdict} aria-rowindex={index + 3} style={{ height: ROW_HEIGHT }}>
      <td className={classes.no}>
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
      <td className={classes.verdict}>
        <span aria-hidden>{sign}</span> {label}
      </td>
      {failures && (
        <td className={classes.message} title={item.message ?? undefined}>
          {item.message && <UserText>{item.message}</UserText>}
        </td>
      )}
      {sequences && (
        <td className={classes.message} title={item.steps.map(({ name }) => name).join(' ')}>
          <UserText>{item.steps.map(({ name }) => name).join(' ')}</UserText>
        </td>
      )}
      {groups.flatMap((group) =>
        group.columns.map((column) => (
          <Value key={column.index} text={item.values[column.index] ?? ''} />
        )),
      )}
      {outputs.map((name) => (
        <Value key={`e ${name}`} text={item.expected?.[name] ?? '–'} />
      ))}
      {outputs.map((name) => (
        <Value key={`a ${name}`} text={item.actual?.[name] ?? '–'} />
      ))}
      {failures &&
        outputs.map((name) => (
          <Value
            key={`d ${name}`}
            text={differenceOf(item.expected?.[name], item.actual?.[name]) ?? ''}
          />
        ))}
      <Time item={item} />
    </tr>
  );
}

/** The median of the repeated calls with half of its interval, else the time of the call. */
function Time({ item: { processingTimeUs, repeated } }: { item: ResultCase }) {
  if (!repeated) return <td>{formatTime(processingTimeUs)}</td>;
  const { medianUs, lowUs, highUs, calls, differs } = repeated;
  const interval =
    lowUs === undefined || highUs === undefined
      ? ''
      : `, 95 % interval ${formatTime(lowUs)} to ${formatTime(highUs)}`;
  const about = `Median of ${plural(calls, 'call')}${interval}; first call ${formatTime(processingTimeUs)}`;
  return (
    <td title={differs ? `${about}. Repeated calls differ: ${differs}` : about}>
      {formatTime(medianUs ?? processingTimeUs)}
      {lowUs !== undefined && highUs !== undefined && ` ± ${formatTime((highUs - lowUs) / 2)}`}
      {differs && ' ≠'}
    </td>
  );
}

function Value({ text }: { text: string }) {
  return (
    <td title={text}>
      <UserText>{text}</UserText>
    </td>
  );
}
