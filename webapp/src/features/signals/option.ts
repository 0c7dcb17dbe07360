import type { EChartsCoreOption } from 'echarts/core';
import { isBinary, type Lane } from './lanes';

/** Pixels. The overlay of the plot relies on these positions. */
export const LEFT = 56;
export const RIGHT = 12;
export const LANE_HEIGHT = 76;
export const AXIS_HEIGHT = 24;
const TITLE_HEIGHT = 22;
const GAP = 6;

const LINE = '#1c7ed6';
const MUTED = '#868e96';

/** The height of a plot with this number of lanes; the axis is below the last one. */
export function plotHeight(lanes: number): number {
  return lanes * LANE_HEIGHT - GAP + AXIS_HEIGHT;
}

/** One small plot per lane, with a common time axis. */
export function plotOption(
  lanes: readonly Lane[],
  [min, max]: readonly [number, number],
): EChartsCoreOption {
  const last = lanes.length - 1;
  return {
    grid: lanes.map((_, index) => ({
      left: LEFT,
      right: RIGHT,
      top: index * LANE_HEIGHT + TITLE_HEIGHT,
      height: LANE_HEIGHT - TITLE_HEIGHT - GAP,
    })),
    xAxis: lanes.map((_, index) => ({
      type: 'value',
      gridIndex: index,
      min,
      max,
      axisLine: { onZero: false, lineStyle: { color: MUTED } },
      axisTick: { show: index === last },
      axisLabel: {
        show: index === last,
        hideOverlap: true,
        showMinLabel: false,
        showMaxLabel: false,
        formatter: (value: number) => String(Number(value.toPrecision(6))),
      },
      splitLine: { lineStyle: { opacity: 0.25 } },
    })),
    yAxis: lanes.map((lane, index) => ({
      type: 'value',
      gridIndex: index,
      ...(isBinary(lane) ? { min: 0, max: 1, interval: 1 } : { scale: true, splitNumber: 2 }),
      axisLine: { onZero: false },
      axisLabel: {
        fontSize: 10,
        width: LEFT - 10,
        overflow: 'truncate',
        formatter: formatTick,
      },
      splitLine: { lineStyle: { opacity: 0.25 } },
    })),
    series: lanes.map((lane, index) => ({
      type: 'line',
      xAxisIndex: index,
      yAxisIndex: index,
      showSymbol: false,
      silent: true,
      // A command or a boolean keeps its value until the next sample.
      ...((isBinary(lane) || lane.name.endsWith('.command')) && { step: 'end' }),
      lineStyle: { width: 1.5, color: LINE },
      data: lane.times.map((time, k) => [time, lane.values[k] ?? '-']),
    })),
  };
}

/** Small numbers have an exponent, as there is room for few digits. */
function formatTick(value: number): string {
  return value !== 0 && Math.abs(value) < 1e-3
    ? value.toExponential(0)
    : String(Number(value.toPrecision(4)));
}
