import { Stack, Table, Text } from '@mantine/core';
import { Fragment } from 'react';
import type { StepResult } from '@/shared/api';
import { formatTime } from '@/shared/lib/format';
import { decides } from '@/shared/lib/steps';
import { VERDICT_LABELS } from '@/shared/lib/verdicts';
import { ScrollTable, UserText } from '@/shared/ui';
import classes from './results.module.css';

const KINDS = { VALID: '', FORBIDDEN: 'forbidden', INVALID: 'invalid value' } as const;

/** The steps of a sequence. The first one that did not pass is marked, because it decides. */
export function StepList({ steps }: { steps: readonly StepResult[] }) {
  if (steps.length === 0) return null;
  return (
    <Stack gap={4}>
      <Text size="sm" fw={600}>
        Steps
      </Text>
      <ScrollTable label="Steps" minWidth={520} highlightOnHover={false}>
        <Table.Thead>
          <Table.Tr>
            <Table.Th ta="right">No</Table.Th>
            <Table.Th>Verdict</Table.Th>
            <Table.Th>Step</Table.Th>
            <Table.Th>Expected</Table.Th>
            <Table.Th>Actual</Table.Th>
            <Table.Th ta="right">At (s)</Table.Th>
            <Table.Th ta="right">Time</Table.Th>
          </Table.Tr>
        </Table.Thead>
        <Table.Tbody>
          {steps.map((step, index) => (
            <StepRows key={index} no={index + 1} step={step} />
          ))}
        </Table.Tbody>
      </ScrollTable>
    </Stack>
  );
}

function StepRows({ no, step }: { no: number; step: StepResult }) {
  const { label, sign } = VERDICT_LABELS[step.verdict];
  const first = decides(step);
  const remarks = [
    KINDS[step.kind],
    step.afterFailure && step.verdict !== 'PASS' ? 'after a failure' : '',
    first ? 'decides the verdict' : '',
  ].filter((remark) => remark !== '');
  const about = [
    ...remarks,
    ...(step.before !== undefined && step.before !== '' ? [`state before: ${step.before}`] : []),
  ];
  return (
    <Fragment>
      <Table.Tr
        className={classes.step ?? ''}
        data-verdict={step.verdict}
        data-decides={first || undefined}
      >
        <Table.Td ta="right">{no}</Table.Td>
        <Table.Td className={classes.verdict ?? ''}>
          <span aria-hidden>{sign}</span> {label}
        </Table.Td>
        <Table.Td>
          <UserText>{step.name}</UserText>
          {about.length > 0 && (
            <Text size="xs" c="dimmed">
              <UserText>{about.join('; ')}</UserText>
            </Text>
          )}
          {Object.entries(step.inputs).map(([name, value]) => (
            <Text key={name} size="xs" ff="monospace">
              <UserText>{`${name} = ${value}`}</UserText>
            </Text>
          ))}
        </Table.Td>
        <Outputs values={step.expected} />
        <Outputs values={step.actual} />
        <Table.Td ta="right">
          {step.at === undefined ? '–' : Number(step.at.toPrecision(6))}
        </Table.Td>
        <Table.Td ta="right">{formatTime(step.processingTimeUs)}</Table.Td>
      </Table.Tr>
      {step.message && (
        <Table.Tr className={classes.step ?? ''} data-decides={first || undefined}>
          <Table.Td />
          <Table.Td colSpan={6}>
            <Text size="sm" className={classes.whole}>
              <UserText>{step.message}</UserText>
            </Text>
          </Table.Td>
        </Table.Tr>
      )}
    </Fragment>
  );
}

/** A return value without its name, or several outputs. */
function Outputs({ values }: { values: Record<string, string> }) {
  const entries = Object.entries(values);
  return (
    <Table.Td>
      {entries.map(([name, value]) => (
        <Text key={name} size="xs" ff="monospace">
          <UserText>{entries.length === 1 ? value : `${name} = ${value}`}</UserText>
        </Text>
      ))}
    </Table.Td>
  );
}
