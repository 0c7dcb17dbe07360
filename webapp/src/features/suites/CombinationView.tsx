import { Group, NativeSelect, Stack, Table, Text } from '@mantine/core';
import type { EChartsCoreOption } from 'echarts/core';
import { useMemo, useState } from 'react';
import type { Combinations, Suite } from '@/shared/api';
import { plural } from '@/shared/lib/format';
import { Chart, Loading, ProblemAlert, ScrollTable, UserText } from '@/shared/ui';
import { useCombinations } from './queries';

/** Shows which pairs of values occur together in a case. */
export function CombinationView({ suite }: { suite: Suite }) {
  const [first, setFirst] = useState(0);
  const [second, setSecond] = useState(1);
  const hasPairs = suite.parameters.length > 1;
  const combinations = useCombinations(
    suite.id,
    suite.version,
    hasPairs ? [first, second] : undefined,
  );
  if (combinations.isPending) return <Loading what="the combinations" />;
  if (!combinations.data) {
    return <ProblemAlert title="The combinations could not be read" error={combinations.error} />;
  }
  if (!hasPairs)
    return (
      <Text c="dimmed">
        The cases begin with fewer than two parameters, so there are no combinations.
      </Text>
    );
  const { parameters, pairs, counts } = combinations.data;
  const names = parameters.map(({ name }, index) => ({ value: String(index), label: name }));
  return (
    <Stack gap="md">
      <Group>
        <NativeSelect
          label="Parameter"
          data={names}
          value={String(first)}
          onChange={(event) => {
            setFirst(Number(event.currentTarget.value));
          }}
        />
        <NativeSelect
          label="With"
          data={names}
          value={String(second)}
          onChange={(event) => {
            setSecond(Number(event.currentTarget.value));
          }}
        />
      </Group>
      {counts && <Heatmap parameters={parameters} counts={counts} />}
      <ScrollTable label="Pairs of parameters" minWidth={420}>
        <Table.Thead>
          <Table.Tr>
            <Table.Th>Parameters</Table.Th>
            <Table.Th ta="right">Covered pairs of values</Table.Th>
            <Table.Th ta="right">Coverage</Table.Th>
          </Table.Tr>
        </Table.Thead>
        <Table.Tbody>
          {pairs.map((pair) => (
            <Table.Tr key={`${pair.first} ${pair.second}`}>
              <Table.Td>
                <UserText>
                  {`${parameters[pair.first]?.name ?? ''} × ${parameters[pair.second]?.name ?? ''}`}
                </UserText>
              </Table.Td>
              <Table.Td ta="right">
                {pair.covered} of {pair.possible}
              </Table.Td>
              <Table.Td ta="right">{Math.round((100 * pair.covered) / pair.possible)} %</Table.Td>
            </Table.Tr>
          ))}
        </Table.Tbody>
      </ScrollTable>
    </Stack>
  );
}

type Counts = NonNullable<Combinations['counts']>;

function Heatmap({
  parameters,
  counts,
}: {
  parameters: Combinations['parameters'];
  counts: Counts;
}) {
  const option = useMemo(() => heatmap(parameters, counts), [parameters, counts]);
  const cells = counts.cases.flat();
  const covered = cells.filter((cell) => cell > 0).length;
  return (
    <Chart
      label={`${covered} of ${plural(cells.length, 'pair')} of values of ${parameters[counts.first]?.name ?? ''} and ${parameters[counts.second]?.name ?? ''} occur in a case`}
      option={option}
      height={Math.min(640, 140 + 32 * counts.cases.length)}
    />
  );
}

function heatmap(parameters: Combinations['parameters'], counts: Counts): EChartsCoreOption {
  const rows = parameters[counts.first];
  const columns = parameters[counts.second];
  const data = counts.cases.flatMap((row, y) => row.map((count, x) => [x, y, count]));
  const largest = Math.max(1, ...counts.cases.flat());
  return {
    tooltip: { position: 'top' },
    grid: { left: 90, right: 30, top: 30, bottom: 70 },
    xAxis: {
      type: 'category',
      data: columns?.values ?? [],
      name: columns?.name,
      nameLocation: 'middle',
      nameGap: 26,
    },
    yAxis: { type: 'category', data: rows?.values ?? [], name: rows?.name },
    visualMap: {
      type: 'piecewise',
      orient: 'horizontal',
      left: 'center',
      bottom: 0,
      pieces: [
        { value: 0, label: 'never', color: 'rgba(128,128,128,0.12)' },
        { value: 1, label: 'once', color: '#78bac3' },
        ...(largest > 1 ? [{ min: 2, label: 'repeatedly', color: '#0b6874' }] : []),
      ],
    },
    series: [
      {
        type: 'heatmap',
        data,
        label: {
          show: counts.cases.flat().length <= 400,
          // An empty cell is easier to see than a zero.
          formatter: ({ value: [, , count] }: { value: [number, number, number] }) =>
            count === 0 ? '' : String(count),
        },
        itemStyle: { borderColor: 'rgba(128,128,128,0.35)', borderWidth: 1 },
      },
    ],
  };
}
