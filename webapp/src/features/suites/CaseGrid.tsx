import { Stack, Text } from '@mantine/core';
import { useQueryClient } from '@tanstack/react-query';
import { useState, type ClipboardEvent, type KeyboardEvent } from 'react';
import type { Suite, SuiteCase } from '@/shared/api';
import { groupColumns } from '@/shared/lib/columns';
import { formatCount } from '@/shared/lib/format';
import { Loading, ProblemAlert, UserText, useVirtualPages } from '@/shared/ui';
import { Conflict } from './Conflict';
import { GridTools } from './GridTools';
import { CASES_PER_PAGE, useFetchCases, type ExpectedChange } from './queries';
import { StepDrawer } from './StepDrawer';
import { StepSummary } from './StepSummary';
import classes from './suites.module.css';
import { cellKey, useEdits, type Edits } from './useEdits';

const ROW_HEIGHT = 34;

interface CaseGridProps {
  suite: Suite;
  /** Names of the outputs of the suite's test model. */
  outputs: readonly string[];
  /** Whether the cases are sequences of steps. */
  sequences?: boolean;
}

/** The cases of a suite (Fig. 15) with their expected values, which can be edited. */
export function CaseGrid({ suite, outputs, sequences = false }: CaseGridProps) {
  const edits = useEdits(suite);
  const fetched = useFetchCases(suite.id);
  const { scroller, rows, above, below, error, loading, scrollTo } = useVirtualPages<SuiteCase>({
    total: suite.total,
    pageSize: CASES_PER_PAGE,
    rowHeight: ROW_HEIGHT,
    ...fetched,
  });
  const groups = groupColumns(suite.parameters);
  const paste = usePaste(fetched, suite, outputs, edits);
  const [opened, setOpened] = useState<SuiteCase | null>(null);

  if (loading && rows.every(({ item }) => !item)) return <Loading what="test cases" />;
  return (
    <Stack gap="sm">
      <GridTools suite={suite} outputs={outputs} edits={edits} sequences={sequences} />
      {edits.conflict && <Conflict suite={suite} edits={edits} />}
      {edits.error && !edits.conflict && (
        <ProblemAlert
          title="The change was not saved"
          error={edits.error}
          onClose={edits.discard}
        />
      )}
      {error && <ProblemAlert title="Some cases could not be read" error={error} />}
      <div
        ref={scroller}
        className={classes.scroller}
        tabIndex={0}
        role="group"
        aria-label="Test cases"
      >
        <table
          className={classes.grid}
          aria-label="Test cases"
          aria-rowcount={suite.total + 2}
          style={{ minWidth: `${20 + suite.parameters.length * 8 + outputs.length * 10}rem` }}
        >
          <colgroup>
            <col style={{ width: '5rem' }} />
            <col style={{ width: '6rem' }} />
            {suite.parameters.map(({ name }) => (
              <col key={name} />
            ))}
            {sequences && <col {...(suite.parameters.length > 0 && { style: { width: '60%' } })} />}
            {outputs.map((name) => (
              <col key={name} style={{ width: '11rem' }} />
            ))}
          </colgroup>
          <thead>
            <tr>
              <th rowSpan={2}>No</th>
              <th rowSpan={2}>Class</th>
              {groups.map((group) => (
                <th key={group.type} colSpan={group.columns.length} scope="colgroup">
                  {group.label}
                </th>
              ))}
              {sequences && (
                <th rowSpan={2} className={classes.steps}>
                  Steps
                </th>
              )}
              {outputs.length > 0 && (
                <th colSpan={outputs.length} scope="colgroup">
                  Expected
                </th>
              )}
            </tr>
            <tr>
              {groups.flatMap((group) =>
                group.columns.map(({ parameter, index }) => (
                  <th key={index}>
                    <UserText>{parameter.name}</UserText>
                  </th>
                )),
              )}
              {outputs.map((name) => (
                <th key={name}>
                  <UserText>{name}</UserText>
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {above > 0 && (
              <tr aria-hidden>
                <td className={classes.space} style={{ height: above }} />
              </tr>
            )}
            {rows.map(({ index, item }) =>
              item ? (
                <tr
                  key={index}
                  data-class={item.valid ? 'valid' : 'invalid'}
                  aria-rowindex={index + 3}
                  style={{ height: ROW_HEIGHT }}
                >
                  <td>{item.no}</td>
                  <td>{item.valid ? 'valid' : 'invalid'}</td>
                  {groups.flatMap((group) =>
                    group.columns.map((column) => (
                      <td key={column.index} title={item.values[column.index]}>
                        <UserText>{item.values[column.index] ?? ''}</UserText>
                      </td>
                    )),
                  )}
                  {sequences && (
                    <td>
                      <StepSummary
                        item={item}
                        onOpen={() => {
                          setOpened(item);
                        }}
                      />
                    </td>
                  )}
                  {outputs.map((output, at) => (
                    <td key={output} className={classes.cell}>
                      <ExpectedCell
                        item={item}
                        output={output}
                        stored={expectedOf(item, output, outputs)}
                        draft={edits.drafts.get(cellKey(item.no, nameOf(output, outputs)))}
                        onSet={(literal) => {
                          edits.set([change(item.no, output, outputs, literal)]);
                        }}
                        onPaste={(text) => void paste(index, at, text)}
                        onMove={(step) => {
                          scrollTo(Math.max(0, Math.min(suite.total - 1, index + step)));
                          focusCell(scroller.current, index + step, at);
                        }}
                        place={`${index} ${at}`}
                      />
                    </td>
                  ))}
                </tr>
              ) : (
                <tr key={index} style={{ height: ROW_HEIGHT }} aria-hidden />
              ),
            )}
            {below > 0 && (
              <tr aria-hidden>
                <td className={classes.space} style={{ height: below }} />
              </tr>
            )}
          </tbody>
        </table>
      </div>
      <StepDrawer
        item={opened}
        parameters={suite.parameters.map(({ name }) => name)}
        onClose={() => {
          setOpened(null);
        }}
      />
      <Text size="sm" c="dimmed" role="status">
        {formatCount(suite.total)} cases, {formatCount(suite.valid)} valid,{' '}
        {formatCount(suite.invalid)} with an invalid value
        {edits.busy ? ' · saving…' : edits.drafts.size > 0 ? ' · not saved' : ' · saved'}
      </Text>
    </Stack>
  );
}

interface ExpectedCellProps {
  item: SuiteCase;
  output: string;
  stored: string;
  draft: string | undefined;
  place: string;
  onSet: (literal: string) => void;
  onPaste: (text: string) => void;
  onMove: (step: number) => void;
}

function ExpectedCell({
  item,
  output,
  stored,
  draft,
  place,
  onSet,
  onPaste,
  onMove,
}: ExpectedCellProps) {
  const [typed, setTyped] = useState<string>();
  const shown = typed ?? draft ?? stored;

  function commit() {
    if (typed !== undefined && typed.trim() !== (draft ?? stored)) onSet(typed.trim());
    setTyped(undefined);
  }

  function key(event: KeyboardEvent<HTMLInputElement>) {
    if (event.key === 'Enter' || event.key === 'ArrowDown') {
      event.preventDefault();
      commit();
      onMove(1);
    } else if (event.key === 'ArrowUp') {
      event.preventDefault();
      commit();
      onMove(-1);
    } else if (event.key === 'Escape') {
      setTyped(undefined);
    }
  }

  return (
    <input
      className={classes.input}
      aria-label={`Expected ${output} of case ${item.no}`}
      data-place={place}
      data-unsaved={draft !== undefined || undefined}
      value={shown}
      onChange={(event) => {
        setTyped(event.currentTarget.value);
      }}
      onBlur={commit}
      onKeyDown={key}
      onPaste={(event: ClipboardEvent<HTMLInputElement>) => {
        const text = event.clipboardData.getData('text/plain');
        // A single value is pasted at the cursor.
        if (!/[\n\t]/.test(text.trimEnd())) return;
        event.preventDefault();
        setTyped(undefined);
        onPaste(text);
      }}
    />
  );
}

/** The name of an output in the cases; a single output has none. */
function nameOf(output: string, outputs: readonly string[]): string {
  return outputs.length === 1 ? '' : output;
}

/** The server lists the value of a single output under `return`, whatever the output is called. */
function expectedOf(item: SuiteCase, output: string, outputs: readonly string[]): string {
  const value = item.expected[output];
  return value ?? (outputs.length === 1 ? item.expected['return'] : undefined) ?? '';
}

function change(
  no: number,
  output: string,
  outputs: readonly string[],
  literal: string,
): ExpectedChange {
  const name = nameOf(output, outputs);
  return { no, ...(name && { output: name }), ...(literal !== '' && { literal }) };
}

/** Pastes rows of a spreadsheet from a cell downwards and to the right. */
function usePaste(
  { queryKey, fetchPage }: ReturnType<typeof useFetchCases>,
  suite: Suite,
  outputs: readonly string[],
  edits: Edits,
) {
  const cache = useQueryClient();
  return async (firstRow: number, firstOutput: number, text: string) => {
    const lines = text.replace(/\r?\n$/, '').split(/\r?\n/);
    const changes: ExpectedChange[] = [];
    for (const [offset, line] of lines.entries()) {
      const index = firstRow + offset;
      if (index >= suite.total) break;
      const page = Math.floor(index / CASES_PER_PAGE);
      const { items } = await cache.query({
        queryKey: [...queryKey, 'page', page],
        queryFn: ({ signal }) => fetchPage(page, signal),
        staleTime: Infinity,
      });
      const item = items[index % CASES_PER_PAGE];
      if (!item) break;
      for (const [column, value] of line.split('\t').entries()) {
        const output = outputs[firstOutput + column];
        if (output) changes.push(change(item.no, output, outputs, value.trim()));
      }
    }
    edits.set(changes);
  };
}

/** Focuses a cell after its row has been rendered. */
function focusCell(scroller: HTMLElement | null, row: number, output: number) {
  requestAnimationFrame(() => {
    scroller?.querySelector<HTMLInputElement>(`input[data-place="${row} ${output}"]`)?.focus();
  });
}
