import { Badge, Group, Stack, Table, Text } from '@mantine/core';
import type { ReactNode } from 'react';
import type { ResultFailures, ResultSummary } from '@/shared/api';
import { shortCommit } from '@/shared/lib/commits';
import { formatCount, plural } from '@/shared/lib/format';
import { VERDICT_LABELS } from '@/shared/lib/verdicts';
import { Age, Loading, ProblemAlert, RouteLink, ScrollTable, UserText } from '@/shared/ui';
import { useCase, useFailures, useResult } from './queries';
import { CaseValues } from './CaseValues';
import classes from './results.module.css';

interface ResultAnswerProps {
  buildId: string;
  summary: ResultSummary;
  /** The replay of a case, shown next to its values. */
  replay?: ((no: number) => ReactNode) | undefined;
  onCase: (no: number) => void;
}

/** What failed, since when, and the first failing case. */
export function ResultAnswer({ buildId, summary, replay, onCase }: ResultAnswerProps) {
  const failing = summary.fail + summary.error;
  const failures = useFailures(buildId, summary.pass < summary.total);
  return (
    <Stack gap="sm" className={classes.answer ?? ''}>
      <Group gap="md">
        <Text className={classes.headline ?? ''} data-tone={toneOf(summary)}>
          {headlineOf(summary)}
        </Text>
        {failures.data?.since && <SinceWhen buildId={buildId} failures={failures.data} />}
      </Group>
      {summary.pass < summary.total && failures.isPending && <Loading what="what failed" />}
      {failures.error && (
        <ProblemAlert title="What failed could not be read" error={failures.error} />
      )}
      {failures.data && failures.data.groups.length > 0 && (
        <div className={failing > 0 ? classes.answers : undefined}>
          <Groups failures={failures.data} onCase={onCase} />
          {failures.data.firstFailing !== undefined && (
            <FirstFailing buildId={buildId} no={failures.data.firstFailing} replay={replay} />
          )}
        </div>
      )}
    </Stack>
  );
}

function headlineOf({ total, pass, fail, error, dont }: ResultSummary): string {
  if (pass === total)
    return total === 1 ? 'The case passed' : `All ${formatCount(total)} cases passed`;
  const failing = fail + error;
  const rest = dont > 0 ? `, ${formatCount(dont)} not executed` : '';
  return failing > 0
    ? `${formatCount(failing)} of ${plural(total, 'case')} fail${rest}`
    : `${formatCount(dont)} of ${plural(total, 'case')} not executed`;
}

function toneOf({ total, pass, fail, error }: ResultSummary): string {
  if (pass === total) return 'good';
  return fail + error > 0 ? 'bad' : 'waiting';
}

/** Since which build results fail, and what the result before says. */
function SinceWhen({ buildId, failures }: { buildId: string; failures: ResultFailures }) {
  const { since, before } = failures;
  if (!since) return null;
  const first = since.buildId === buildId;
  return (
    <Text size="sm" c="dimmed">
      {first ? (
        before ? (
          <>
            New in this build: all passed in the{' '}
            <RouteLink to="/builds/$buildId" params={{ buildId: before.buildId }} size="sm">
              build before
            </RouteLink>
            , <Age at={before.received} />.
          </>
        ) : (
          'This is the first result of the test model.'
        )
      ) : (
        <>
          Failing since the{' '}
          <RouteLink to="/builds/$buildId" params={{ buildId: since.buildId }} size="sm">
            build of <Age at={since.received} />
          </RouteLink>
          {since.commit && (
            <>
              {' (commit '}
              <UserText>{shortCommit(since.commit)}</UserText>)
            </>
          )}
          , {plural(since.results, 'result')} in a row
          {since.passedBefore ? '.' : '; no earlier result passed.'}
        </>
      )}{' '}
      {before && !first && <Changes before={before} />}
    </Text>
  );
}

function Changes({ before }: { before: NonNullable<ResultFailures['before']> }) {
  const { newlyFailing, stillFailing, fixed } = before;
  return (
    <>
      Against the{' '}
      <RouteLink to="/builds/$buildId" params={{ buildId: before.buildId }} size="sm">
        build before
      </RouteLink>
      : {formatCount(newlyFailing)} newly failing, {formatCount(stillFailing)} still failing,{' '}
      {formatCount(fixed)} fixed.
    </>
  );
}

function Groups({ failures, onCase }: { failures: ResultFailures; onCase: (no: number) => void }) {
  return (
    <Stack gap="xs">
      <ScrollTable label="What failed" minWidth={360} verticalSpacing={6}>
        <Table.Thead>
          <Table.Tr>
            <Table.Th ta="right">Cases</Table.Th>
            <Table.Th>Verdict</Table.Th>
            <Table.Th>Message</Table.Th>
          </Table.Tr>
        </Table.Thead>
        <Table.Tbody>
          {failures.groups.map((group) => (
            <Table.Tr
              key={`${group.verdict} ${String(group.numbers[0])}`}
              data-verdict={group.verdict}
            >
              <Table.Td ta="right" fw={600}>
                {formatCount(group.cases)}
              </Table.Td>
              <Table.Td className={classes.verdict ?? ''}>
                <span aria-hidden>{VERDICT_LABELS[group.verdict].sign}</span>{' '}
                {VERDICT_LABELS[group.verdict].label}
              </Table.Td>
              <Table.Td className={classes.reason ?? ''}>
                <UserText>{group.message === '' ? 'No message' : group.message}</UserText>
                <Text size="xs" c="dimmed" component="div">
                  {!group.uniform && 'Numbers differ between the cases. '}
                  Case{group.cases > 1 ? 's' : ''}{' '}
                  {group.numbers.slice(0, MAX_NUMBERS).map((no, index) => (
                    <span key={no}>
                      {index > 0 && ', '}
                      <button
                        type="button"
                        className={classes.open}
                        aria-label={`Open case ${no}`}
                        onClick={() => {
                          onCase(no);
                        }}
                      >
                        {no}
                      </button>
                    </span>
                  ))}
                  {group.cases > MAX_NUMBERS && ', …'}{' '}
                  {group.newlyFailing !== undefined && group.newlyFailing > 0 && (
                    <Badge size="xs" color="red" variant="light">
                      {formatCount(group.newlyFailing)} new
                    </Badge>
                  )}
                </Text>
              </Table.Td>
            </Table.Tr>
          ))}
        </Table.Tbody>
      </ScrollTable>
      {failures.leftOut > 0 && (
        <Text size="sm" c="dimmed">
          {plural(failures.leftOut, 'other group')} with fewer cases.
        </Text>
      )}
    </Stack>
  );
}

/** Numbers of cases that are listed for each group. */
const MAX_NUMBERS = 8;

function FirstFailing({
  buildId,
  no,
  replay,
}: {
  buildId: string;
  no: number;
  replay?: ((no: number) => ReactNode) | undefined;
}) {
  const result = useResult(buildId);
  const item = useCase(buildId, no);
  if (!result.data || !item.data) return null;
  return (
    <section className={classes.first} aria-label="First failing case">
      <Group justify="space-between" gap="sm">
        <Text fw={600}>First failing case: {no}</Text>
        <RouteLink
          to="/builds/$buildId/cases/$caseNo"
          params={{ buildId, caseNo: String(no) }}
          size="sm"
        >
          Open case {no}
        </RouteLink>
      </Group>
      {item.data.steps.length === 0 && (
        <CaseValues item={item.data} parameters={result.data.parameters} />
      )}
      {replay?.(no)}
    </section>
  );
}
