import type { EChartsCoreOption } from 'echarts/core';
import type { ResultStatistics, ResultSummary } from '@/shared/api';
import { formatTime, inUnit, timeUnitOf } from '@/shared/lib/format';
import { VERDICTS, VERDICT_COLOURS, VERDICT_LABELS, countOf } from '@/shared/lib/verdicts';

const LINE = '#2a94a2';

type Times = NonNullable<ResultStatistics['times']>;
type ByParameter = ResultStatistics['parameters'][number];
export type TellingPair = NonNullable<ResultStatistics['tellingPair']>;

/** The cells of larger maps have no room for a label. */
const MAX_LABELLED_CELLS = 120;

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

export function timeHistogram({ histogram, max }: Times): EChartsCoreOption {
  const unit = timeUnitOf(max);
  return {
    tooltip: { trigger: 'axis' },
    grid: { left: 50, right: 20, top: 20, bottom: 50 },
    xAxis: {
      type: 'category',
      name: unit.name,
      nameLocation: 'middle',
      nameGap: 30,
      data: histogram.map(({ from, to }) => `${inUnit(from, unit)} to ${formatTime(to)}`),
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

/**
 * A point for each case, or a box plot of successive cases if there are many. Cases are unrelated,
 * so no line joins them.
 */
export function timesOverCases({ overCases, max }: Times): EChartsCoreOption {
  const unit = timeUnitOf(max);
  const boxes = overCases.some(({ firstNo, lastNo }) => firstNo !== lastNo);
  const numbers = overCases.map(({ firstNo, lastNo }) =>
    firstNo === lastNo ? String(firstNo) : `${String(firstNo)} to ${String(lastNo)}`,
  );
  return {
    tooltip: {
      trigger: 'item',
      formatter: ({ dataIndex }: { dataIndex: number }) =>
        describeTimes(overCases[dataIndex], numbers[dataIndex] ?? ''),
    },
    grid: { left: 70, right: 20, top: 30, bottom: 50 },
    xAxis: {
      type: boxes ? 'category' : 'value',
      name: boxes ? 'cases' : 'case',
      nameLocation: 'middle',
      nameGap: 30,
      ...(boxes
        ? { data: numbers, axisLabel: { hideOverlap: true } }
        : { min: 'dataMin', max: 'dataMax', minInterval: 1 }),
    },
    yAxis: { type: 'value', name: unit.name, scale: true },
    series: [
      boxes
        ? {
            type: 'boxplot',
            itemStyle: { color: 'transparent', borderColor: LINE },
            data: overCases.map((point) =>
              [point.min, point.q1, point.median, point.q3, point.max].map((us) => us / unit.us),
            ),
          }
        : {
            type: 'scatter',
            symbolSize: 6,
            itemStyle: { color: LINE, opacity: 0.75 },
            data: overCases.map(({ firstNo, median }) => [firstNo, median / unit.us]),
          },
    ],
  };
}

function describeTimes(point: Times['overCases'][number] | undefined, numbers: string): string {
  if (!point) return '';
  return point.firstNo === point.lastNo
    ? `Case ${numbers}: ${formatTime(point.median)}`
    : `Cases ${numbers}: median ${formatTime(point.median)}, quartiles ${formatTime(point.q1)} and ${formatTime(point.q3)}, from ${formatTime(point.min)} to ${formatTime(point.max)}`;
}

/** The share of failing cases for each pair of values of two parameters. */
export function verdictMap(pair: TellingPair): EChartsCoreOption {
  const { first, second, firstValues, secondValues, cells } = pair;
  const share = (cell: TellingPair['cells'][number]) => {
    const executed = cell.pass + cell.fail + cell.error;
    return executed === 0 ? NaN : (cell.fail + cell.error) / executed;
  };
  return {
    tooltip: {
      formatter: ({ dataIndex }: { dataIndex: number }) => {
        const cell = cells[dataIndex];
        return cell ? escapeHtml(describeCell(pair, cell)) : '';
      },
    },
    grid: { left: 60, right: 20, top: 30, bottom: 50, containLabel: false },
    xAxis: {
      type: 'category',
      name: first,
      nameLocation: 'middle',
      nameGap: 30,
      data: firstValues,
      splitArea: { show: true },
    },
    yAxis: { type: 'category', name: second, data: secondValues, splitArea: { show: true } },
    visualMap: {
      show: false,
      min: 0,
      max: 1,
      dimension: 2,
      inRange: { color: [VERDICT_COLOURS.PASS, '#e3b341', VERDICT_COLOURS.FAIL] },
    },
    series: [
      {
        type: 'heatmap',
        data: cells.map((cell) => [cell.first, cell.second, share(cell)]),
        itemStyle: { borderColor: 'rgba(127, 127, 127, 0.35)', borderWidth: 1 },
        label: {
          show: cells.length <= MAX_LABELLED_CELLS,
          // Readable on all colours of the cells.
          color: '#101418',
          formatter: ({ dataIndex }: { dataIndex: number }) => {
            const cell = cells[dataIndex];
            if (!cell) return '';
            const failing = cell.fail + cell.error;
            return failing === 0 ? '' : `${failing} of ${cell.pass + failing + cell.dont}`;
          },
        },
      },
    ],
  };
}

function describeCell(
  { first, second, firstValues, secondValues }: TellingPair,
  cell: TellingPair['cells'][number],
): string {
  const executed = cell.pass + cell.fail + cell.error;
  return (
    `${first} = ${firstValues[cell.first] ?? ''}, ${second} = ${secondValues[cell.second] ?? ''}: ` +
    `${cell.fail + cell.error} of ${executed} fail` +
    (cell.dont > 0 ? `, ${cell.dont} not executed` : '')
  );
}

/** Tooltips are HTML, and values come from users. */
function escapeHtml(text: string): string {
  return text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');
}

/** The pairs of values for which all executed cases fail, or else those with the most failures. */
export function failingPairs(pair: TellingPair, max: number): string[] {
  const failing = pair.cells.filter(({ fail, error }) => fail + error > 0);
  const whole = failing.filter(({ pass }) => pass === 0);
  return (whole.length > 0 ? whole : failing)
    .toSorted((a, b) => b.fail + b.error - (a.fail + a.error))
    .slice(0, max)
    .map((cell) => describeCell(pair, cell));
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
