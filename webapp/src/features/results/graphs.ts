import type { EChartsCoreOption } from 'echarts/core';
import type { ResultStatistics, ResultSummary } from '@/shared/api';
import { formatTime } from '@/shared/lib/format';
import { VERDICTS, VERDICT_COLOURS, VERDICT_LABELS, countOf } from '@/shared/lib/verdicts';

const LINE = '#2a94a2';

type Times = NonNullable<ResultStatistics['times']>;
type ByParameter = ResultStatistics['parameters'][number];

export function verdictPie(summary: ResultSummary): EChartsCoreOption {
  return {
    tooltip: { trigger: 'item' },
    legend: { bottom: 0 },
    series: [
      {
        type: 'pie',
        radius: ['45%', '72%'],
        center: ['50%', '44%'],
        label: { formatter: '{d} %' },
        data: VERDICTS.filter((verdict) => countOf(summary, verdict) > 0).map((verdict) => ({
          name: VERDICT_LABELS[verdict].label,
          value: countOf(summary, verdict),
          itemStyle: { color: VERDICT_COLOURS[verdict] },
        })),
      },
    ],
  };
}

export function timeHistogram({ histogram }: Times): EChartsCoreOption {
  return {
    tooltip: { trigger: 'axis' },
    grid: { left: 50, right: 20, top: 20, bottom: 50 },
    xAxis: {
      type: 'category',
      name: 'µs',
      nameLocation: 'middle',
      nameGap: 30,
      data: histogram.map(({ from, to }) => `${formatTime(from)} to ${formatTime(to)}`),
      axisLabel: { formatter: (label: string) => label.split(' to ')[0] ?? '' },
    },
    yAxis: { type: 'value', name: 'cases', minInterval: 1 },
    series: [
      {
        type: 'bar',
        barCategoryGap: '5%',
        itemStyle: { color: LINE },
        data: histogram.map(({ count }) => count),
      },
    ],
  };
}

export function timesOverCases({ overCases }: Times): EChartsCoreOption {
  const aggregated = overCases.some(({ firstNo, lastNo }) => firstNo !== lastNo);
  const line = (
    name: string,
    pick: (point: (typeof overCases)[number]) => number,
    bold: boolean,
  ) => ({
    type: 'line',
    name,
    showSymbol: false,
    lineStyle: { width: bold ? 2 : 1, color: LINE, opacity: bold ? 1 : 0.45 },
    itemStyle: { color: LINE },
    data: overCases.map((point) => [point.firstNo, pick(point)]),
  });
  return {
    tooltip: {
      trigger: 'axis',
      valueFormatter: (value: unknown) => `${formatTime(Number(value))} µs`,
    },
    grid: { left: 60, right: 20, top: 20, bottom: 50 },
    dataZoom: [{ type: 'inside' }],
    xAxis: {
      type: 'value',
      name: 'case',
      nameLocation: 'middle',
      nameGap: 30,
      min: 'dataMin',
      max: 'dataMax',
    },
    yAxis: { type: 'value', name: 'µs', scale: true },
    series: aggregated
      ? [
          line('max', ({ max }) => max, false),
          line('average', ({ average }) => average, true),
          line('min', ({ min }) => min, false),
        ]
      : [line('time', ({ average }) => average, true)],
  };
}

export function verdictsByValue({ name, values }: ByParameter): EChartsCoreOption {
  return {
    tooltip: { trigger: 'axis', axisPointer: { type: 'shadow' } },
    grid: { left: 50, right: 20, top: 20, bottom: 50 },
    xAxis: {
      type: 'category',
      name,
      nameLocation: 'middle',
      nameGap: 30,
      data: values.map(({ value }) => value),
    },
    yAxis: { type: 'value', name: 'cases', minInterval: 1 },
    series: VERDICTS.map((verdict) => ({
      type: 'bar',
      stack: 'verdict',
      name: VERDICT_LABELS[verdict].label,
      itemStyle: { color: VERDICT_COLOURS[verdict] },
      data: values.map((value) => countOf(value, verdict)),
    })),
  };
}

/** Describes the values of a parameter for which cases fail. */
export function faultyValues({ name, values }: ByParameter): string {
  const faulty = values.filter(({ fail, error }) => fail + error > 0);
  return faulty.length === 0
    ? `${name}: no failing values`
    : `${name}: cases fail for ${faulty
        .map((v) => `${v.value} (${v.fail + v.error} of ${v.pass + v.fail + v.error + v.dont})`)
        .join(', ')}`;
}
