import { Badge, Group, SegmentedControl, Stack, Table, Text } from '@mantine/core';
import { useMemo } from 'react';
import type { CaseHistory as History, CasePoint } from '@/shared/api';
import { shortCommit } from '@/shared/lib/commits';
import { formatTime } from '@/shared/lib/format';
import { VERDICT_LABELS } from '@/shared/lib/verdicts';
import {
  Age,
  Chart,
  Loading,
  Pager,
  ProblemAlert,
  RouteLink,
  ScrollTable,
  UserText,
} from '@/shared/ui';
import { caseHistoryOption, isShown } from './caseHistoryOption';
import { POINTS_PER_PAGE, useCaseHistory, type CaseOfBuild, type Points } from './queries';

const CHOICES = [
  { value: 'COMMITS', label: 'Commits of the branch' },
  { value: 'BUILDS', label: 'All builds' },
] as const;

const STATE_LABELS: Record<CasePoint['state'], string> = {
  JUDGED: '',
  ABSENT: 'Not in this build',
  NO_RESULT: 'No result',
  PENDING: 'Running',
  NOT_BUILT: 'Not built',
  INVALID: 'Cannot be built',
};

interface CaseHistoryProps {
  testCase: CaseOfBuild;
  /** From 0. */
  page: number;
  onPage: (page: number) => void;
  onPoints: (points: Points) => void;
}

/** What a case did in all commits of a branch, or in all builds of its model, newest first. */
export function CaseHistory({ testCase, page, onPage, onPoints }: CaseHistoryProps) {
  const history = useCaseHistory(testCase, page);
  if (history.isPending) return <Loading what="the history of the case" />;
  if (!history.data) {
    return <ProblemAlert title="The history could not be read" error={history.error} />;
  }
  const { data } = history;
  return (
    <Stack gap="md">
      <Text size="sm">
        <UserText>{inputs(data)}</UserText>
      </Text>
      <SegmentedControl
        aria-label="Points of the history"
        size="xs"
        data={[...CHOICES]}
        value={data.by}
        onChange={onPoints}
        style={{ alignSelf: 'start' }}
      />
      <HistoryChart history={data} />
      {data.items.length === 0 ? (
        <Text c="dimmed">Nothing was built yet.</Text>
      ) : (
        <Points history={data} />
      )}
      <Pager
        label="Pages of the history"
        page={page}
        size={POINTS_PER_PAGE}
        total={data.total}
        onPage={onPage}
      />
    </Stack>
  );
}

function inputs({ parameters, values, steps }: History): string {
  const given = parameters.map((name, index) => `${name} = ${values[index] ?? ''}`).join(', ');
  const sequence = steps === 0 ? '' : `a sequence of ${steps} steps`;
  return [given, sequence].filter(Boolean).join('; ') || 'No inputs';
}

function HistoryChart({ history }: { history: History }) {
  const oldestFirst = useMemo(() => [...history.items].reverse(), [history.items]);
  const chart = useMemo(() => caseHistoryOption(oldestFirst), [oldestFirst]);
  if (oldestFirst.filter(isShown).length < 2 || chart.rows.length === 0) return null;
  return (
    <Chart
      label={`${chart.rows.join(', ')} of the case over time`}
      option={chart.option}
      height={chart.height}
    />
  );
}

function Points({ history }: { history: History }) {
  const { items, by } = history;
  const withMargin = items.some(({ margin }) => margin !== undefined);
  return (
    <ScrollTable label="History of the case" minWidth={720}>
      <Table.Thead>
        <Table.Tr>
          <Table.Th>{by === 'COMMITS' ? 'Commit' : 'Build'}</Table.Th>
          <Table.Th>Verdict</Table.Th>
          <Table.Th>Value</Table.Th>
          {withMargin && <Table.Th ta="right">Margin</Table.Th>}
          <Table.Th ta="right">Median time</Table.Th>
          <Table.Th>Message</Table.Th>
        </Table.Tr>
      </Table.Thead>
      <Table.Tbody>
        {items.map((point, index) => (
          <Table.Tr key={point.commit && by === 'COMMITS' ? point.commit : point.buildId}>
            <Table.Td>
              <Origin point={point} />
            </Table.Td>
            <Table.Td>
              <VerdictOf point={point} />
            </Table.Td>
            <Table.Td>
              <Values point={point} before={buildBefore(items, index)} />
            </Table.Td>
            {withMargin && (
              <Table.Td ta="right">{point.margin && <Margin {...point.margin} />}</Table.Td>
            )}
            <Table.Td ta="right">{point.time ? <Time {...point.time} /> : '–'}</Table.Td>
            <Table.Td>
              {(point.message ?? point.reason) && (
                <Text size="sm" lineClamp={3}>
                  <UserText>{point.message ?? point.reason ?? ''}</UserText>
                </Text>
              )}
            </Table.Td>
          </Table.Tr>
        ))}
      </Table.Tbody>
    </ScrollTable>
  );
}

/** The build with which a point is compared; undefined if it is on the next page. */
function buildBefore(newestFirst: readonly CasePoint[], index: number): string | undefined {
  return newestFirst.slice(index + 1).find((point) => isShown(point) && !point.replaced)?.buildId;
}

/** The commit or the build. */
function Origin({ point }: { point: CasePoint }) {
  const name = point.subject ?? (point.commit ? shortCommit(point.commit) : 'Build');
  return (
    <>
      {point.buildId ? (
        <RouteLink
          to="/builds/$buildId"
          params={{ buildId: point.buildId }}
          search={point.no === undefined ? {} : { case: point.no }}
          size="sm"
        >
          <UserText>{name}</UserText>
        </RouteLink>
      ) : (
        <Text size="sm">
          <UserText>{name}</UserText>
        </Text>
      )}
      <Text size="xs" c="dimmed">
        {point.subject && point.commit && (
          <UserText>{`${shortCommit(point.commit)} · ${point.author ?? ''} · `}</UserText>
        )}
        <Age at={point.at} />
      </Text>
      {point.takenFrom && (
        <Text size="xs" c="dimmed">{`Taken over from ${shortCommit(point.takenFrom)}`}</Text>
      )}
      {point.replaced && (
        <Badge size="sm" color="gray" miw="max-content">
          Removed by a force-push
        </Badge>
      )}
    </>
  );
}

function VerdictOf({ point }: { point: CasePoint }) {
  if (!point.verdict) {
    return (
      <Text size="sm" c="dimmed">
        {STATE_LABELS[point.state]}
      </Text>
    );
  }
  const { label, sign } = VERDICT_LABELS[point.verdict];
  return (
    <Stack gap={2} align="start">
      <Text size="sm" fw={point.verdictChanged ? 700 : 400}>{`${sign} ${label}`}</Text>
      {point.verdictChanged && (
        <Badge size="sm" color="orange" variant="outline" miw="max-content">
          Verdict changed
        </Badge>
      )}
      {point.valid === false && (
        <Text size="xs" c="dimmed">
          Invalid inputs
        </Text>
      )}
      {point.suspect && (
        <Badge size="sm" color="red" miw="max-content">
          Suspect
        </Badge>
      )}
    </Stack>
  );
}

function Values({ point, before }: { point: CasePoint; before: string | undefined }) {
  const values = Object.entries(point.actual);
  const single = values.length === 1;
  return (
    <Stack gap={2} align="start">
      {values.map(([name, value]) => (
        <Text key={name} size="sm" lineClamp={2} fw={point.valueChanged ? 700 : 400}>
          <UserText>{single ? value : `${name}: ${value}`}</UserText>
        </Text>
      ))}
      {point.valueChanged && (
        <Group gap="xs">
          <Badge size="sm" color="orange" variant="outline" miw="max-content">
            Value changed
          </Badge>
          {before && point.buildId && (
            <RouteLink
              to="/builds/$buildId/compare"
              params={{ buildId: point.buildId }}
              search={{ with: before }}
              size="xs"
            >
              Compare
            </RouteLink>
          )}
        </Group>
      )}
    </Stack>
  );
}

function Margin({ condition, value }: NonNullable<CasePoint['margin']>) {
  const number = Number(value);
  return (
    <>
      <Text size="sm">{Number.isFinite(number) ? Number(number.toPrecision(6)) : value}</Text>
      <Text size="xs" c="dimmed">
        <UserText>{condition}</UserText>
      </Text>
    </>
  );
}

function Time({ medianUs, calls, lowUs, highUs }: NonNullable<CasePoint['time']>) {
  return (
    <>
      <Text size="sm">{formatTime(medianUs)}</Text>
      <Text size="xs" c="dimmed">
        {calls === 0
          ? 'one call'
          : lowUs === undefined || highUs === undefined
            ? `${calls} calls`
            : `${formatTime(lowUs)} to ${formatTime(highUs)}`}
      </Text>
    </>
  );
}
