import type { EChartsCoreOption } from 'echarts/core';
import type { CasePoint, Verdict } from '@/shared/api';
import { shortCommit } from '@/shared/lib/commits';
import { formatInstant, timeUnitOf } from '@/shared/lib/format';
import { VERDICT_COLOURS, VERDICT_LABELS } from '@/shared/lib/verdicts';

const ROW_HEIGHT = 110;
const TOP = 24;
const BOTTOM = 36;
const BETWEEN = 28;

/** Verdicts differ in shape, too, so that they are readable without colour. */
const SYMBOLS: Record<Verdict, string> = {
  PASS: 'circle',
  FAIL: 'diamond',
  ERROR: 'triangle',
  DONT: 'emptyCircle',
};

interface Row {
  name: string;
  unit: string;
  /** NaN where there is none. */
  values: number[];
}

/** Whether there is a result of the case. */
export function isShown(point: CasePoint): boolean {
  return point.state === 'JUDGED';
}

/** A row of the chart for the value, the margin and the time, as far as there are numbers. */
export function caseHistoryOption(oldestFirst: readonly CasePoint[]): {
  rows: string[];
  height: number;
  option: EChartsCoreOption;
} {
  const rows = [...valuesOf(oldestFirst), ...marginsOf(oldestFirst), ...timesOf(oldestFirst)];
  const names = oldestFirst.map((point) =>
    point.commit ? shortCommit(point.commit) : formatInstant(point.at),
  );
  return {
    rows: rows.map(({ name }) => name),
    height: TOP + rows.length * ROW_HEIGHT + BOTTOM,
    option: {
      tooltip: {
        trigger: 'item',
        formatter: ({ seriesIndex, dataIndex }: { seriesIndex: number; dataIndex: number }) =>
          describe(rows[seriesIndex], oldestFirst[dataIndex], names[dataIndex] ?? '', dataIndex),
      },
      grid: rows.map((_, index) => ({
        left: 64,
        right: 20,
        top: TOP + index * ROW_HEIGHT,
        height: ROW_HEIGHT - BETWEEN,
      })),
      xAxis: rows.map((_, index) => ({
        type: 'category',
        gridIndex: index,
        // Two points can have the same name.
        data: names.map((name, point) => ({ value: `${name}\n${point}` })),
        axisLabel: {
          show: index === rows.length - 1,
          hideOverlap: true,
          formatter: (label: string) => label.split('\n')[0] ?? '',
        },
      })),
      yAxis: rows.map(({ name, unit }, index) => ({
        type: 'value',
        gridIndex: index,
        name: unit ? `${name} (${unit})` : name,
        nameTextStyle: { align: 'left' },
        nameGap: 8,
        scale: true,
        splitNumber: 2,
      })),
      series: rows.map(({ name, values }, index) => ({
        type: 'line',
        name,
        xAxisIndex: index,
        yAxisIndex: index,
        symbolSize: 8,
        showAllSymbol: true,
        lineStyle: { width: 1, color: '#8a939c' },
        data: values.map((value, point) => {
          const verdict = oldestFirst[point]?.verdict ?? 'DONT';
          return {
            value: Number.isFinite(value) ? value : null,
            symbol: SYMBOLS[verdict],
            itemStyle: { color: VERDICT_COLOURS[verdict] },
          };
        }),
      })),
    },
  };
}

/** The first output that is a number in every point that has it. */
function valuesOf(points: readonly CasePoint[]): Row[] {
  const names = new Set(points.flatMap(({ actual }) => Object.keys(actual)));
  for (const name of names) {
    const literals = points.map(({ actual }) => actual[name]);
    const values = literals.map((literal) =>
      literal === undefined || literal.trim() === '' ? NaN : Number(literal),
    );
    const numeric = literals.every((literal, index) =>
      literal === undefined ? true : Number.isFinite(values[index]),
    );
    if (numeric && values.some(Number.isFinite)) {
      return [{ name: name === 'return' ? 'Value' : name, unit: '', values }];
    }
  }
  return [];
}

function marginsOf(points: readonly CasePoint[]): Row[] {
  const values = points.map(({ margin }) => (margin ? Number(margin.value) : NaN));
  return values.some(Number.isFinite) ? [{ name: 'Margin', unit: '', values }] : [];
}

function timesOf(points: readonly CasePoint[]): Row[] {
  const times = points.map(({ time }) => time?.medianUs ?? NaN);
  const known = times.filter(Number.isFinite);
  if (known.length === 0) return [];
  const unit = timeUnitOf(Math.max(...known));
  return [{ name: 'Median time', unit: unit.name, values: times.map((us) => us / unit.us) }];
}

function describe(
  row: Row | undefined,
  point: CasePoint | undefined,
  name: string,
  index: number,
): string {
  if (!row || !point) return '';
  const value = Number((row.values[index] ?? NaN).toPrecision(6));
  const verdict = point.verdict ? `, ${VERDICT_LABELS[point.verdict].label}` : '';
  return `${name}${verdict}: ${value}${row.unit && ` ${row.unit}`}`;
}
