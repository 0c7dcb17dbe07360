import { Badge, Checkbox, Group, Stack, Table, Text } from '@mantine/core';
import { useMemo, useState } from 'react';
import type { EChartsCoreOption } from 'echarts/core';
import type { ResultOfBuild } from '@/shared/api';
import { shortCommit } from '@/shared/lib/commits';
import { formatInstant, formatTime, inUnit, timeUnitOf } from '@/shared/lib/format';
import { VERDICTS, VERDICT_COLOURS, VERDICT_LABELS, countOf } from '@/shared/lib/verdicts';
import {
  ButtonLink,
  Chart,
  Loading,
  ProblemAlert,
  RouteLink,
  ScrollTable,
  UserText,
} from '@/shared/ui';
import { useHistory } from './queries';

interface ResultHistoryProps {
  activityId: string;
  model?: string;
}

/** The results of an activity over time. Two of them can be selected for a comparison. */
export function ResultHistory({ activityId, model }: ResultHistoryProps) {
  const history = useHistory(activityId, model);
  const [selected, setSelected] = useState<string[]>([]);
  if (history.isPending) return <Loading what="the results" />;
  if (!history.data) {
    return <ProblemAlert title="The results could not be read" error={history.error} />;
  }
  const { items } = history.data;
  if (items.length === 0) return <Text c="dimmed">No results yet.</Text>;
  const newestFirst = items.filter(({ buildId }) => selected.includes(buildId));
  const [now, before] = newestFirst;
  return (
    <Stack gap="sm">
      <HistoryGraph items={items} />
      <Group>
        {now && before ? (
          <ButtonLink
            size="xs"
            to="/builds/$buildId/compare"
            params={{ buildId: now.buildId }}
            search={{ with: before.buildId }}
          >
            Compare selected results
          </ButtonLink>
        ) : (
          <Text size="sm" c="dimmed">
            Select two results to compare them.
          </Text>
        )}
      </Group>
      <ScrollTable label="Results" minWidth={720}>
        <Table.Thead>
          <Table.Tr>
            <Table.Th aria-label="Selected" />
            <Table.Th>Received</Table.Th>
            {!model && <Table.Th>Test model</Table.Th>}
            {VERDICTS.map((verdict) => (
              <Table.Th key={verdict} ta="right">
                {VERDICT_LABELS[verdict].label}
              </Table.Th>
            ))}
            <Table.Th ta="right">Average time</Table.Th>
            <Table.Th>Agent</Table.Th>
            <Table.Th>Commit</Table.Th>
          </Table.Tr>
        </Table.Thead>
        <Table.Tbody>
          {items.map((item) => (
            <Table.Tr key={item.buildId}>
              <Table.Td>
                <Checkbox
                  aria-label={`Select the result of ${formatInstant(item.received)}`}
                  checked={selected.includes(item.buildId)}
                  onChange={({ currentTarget: { checked } }) => {
                    setSelected((old) => {
                      const others = old.filter((id) => id !== item.buildId);
                      // A third selection replaces the first.
                      return checked ? [...others.slice(-1), item.buildId] : others;
                    });
                  }}
                />
              </Table.Td>
              <Table.Td>
                <RouteLink to="/builds/$buildId" params={{ buildId: item.buildId }} size="sm">
                  {formatInstant(item.received)}
                </RouteLink>
                {item.suspect && (
                  <Badge ml="xs" size="sm" color="red">
                    Suspect
                  </Badge>
                )}
              </Table.Td>
              {!model && (
                <Table.Td>
                  <UserText>{item.model}</UserText>
                </Table.Td>
              )}
              {VERDICTS.map((verdict) => (
                <Table.Td key={verdict} ta="right">
                  {countOf(item.summary, verdict)}
                </Table.Td>
              ))}
              <Table.Td ta="right">{formatTime(item.summary.processingTime?.average)}</Table.Td>
              <Table.Td>{item.agent ? <UserText>{item.agent}</UserText> : '–'}</Table.Td>
              <Table.Td>
                {item.commit ? <UserText>{shortCommit(item.commit)}</UserText> : '–'}
              </Table.Td>
            </Table.Tr>
          ))}
        </Table.Tbody>
      </ScrollTable>
    </Stack>
  );
}

function HistoryGraph({ items }: { items: readonly ResultOfBuild[] }) {
  const option = useMemo(() => historyOption([...items].reverse()), [items]);
  if (items.length < 2) return null;
  return (
    <Chart label={`Verdicts of the last ${items.length} results`} option={option} height={220} />
  );
}

function historyOption(oldestFirst: readonly ResultOfBuild[]): EChartsCoreOption {
  const averages = oldestFirst.map(({ summary }) => summary.processingTime?.average ?? null);
  const unit = timeUnitOf(Math.max(...averages.map((average) => average ?? 0)));
  return {
    tooltip: { trigger: 'axis' },
    legend: { top: 0 },
    grid: { left: 50, right: 60, top: 35, bottom: 30 },
    xAxis: {
      type: 'category',
      data: oldestFirst.map(({ received }) => formatInstant(received)),
      axisLabel: { hideOverlap: true },
    },
    yAxis: [
      { type: 'value', name: 'cases', minInterval: 1 },
      { type: 'value', name: unit.name, splitLine: { show: false } },
    ],
    series: [
      ...VERDICTS.map((verdict) => ({
        type: 'bar',
        stack: 'verdict',
        barMaxWidth: 64,
        name: VERDICT_LABELS[verdict].label,
        itemStyle: { color: VERDICT_COLOURS[verdict] },
        data: oldestFirst.map(({ summary }) => countOf(summary, verdict)),
      })),
      {
        type: 'line',
        name: 'Average time',
        yAxisIndex: 1,
        itemStyle: { color: '#2a94a2' },
        data: averages.map(
          (average) => average && Number(inUnit(average, unit).replaceAll(',', '')),
        ),
      },
    ],
  };
}
