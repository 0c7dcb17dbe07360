import { useComputedColorScheme } from '@mantine/core';
import type { EChartsCoreOption, EChartsType } from 'echarts/core';
import { useEffect, useRef } from 'react';
import { useArrived } from '@/shared/lib/arrival';

interface ChartProps {
  /** Describes the chart for screen readers. */
  label: string;
  option: EChartsCoreOption;
  height?: number;
  /** Called with the name of a clicked item. */
  onPick?: (name: string) => void;
}

/** A chart. ECharts is loaded when the first one is shown. */
export function Chart({ label, option, height = 280, onPick }: ChartProps) {
  const place = useRef<HTMLDivElement>(null);
  const dark = useComputedColorScheme('light') === 'dark';
  const arrived = useArrived();
  const pick = useRef(onPick);
  useEffect(() => {
    pick.current = onPick;
  }, [onPick]);
  useEffect(() => {
    if (!arrived) return;
    let chart: EChartsType | undefined;
    let disposed = false;
    const resize = new ResizeObserver(() => chart?.resize());
    void import('./echarts').then(({ init }) => {
      if (disposed || !place.current) return;
      chart = init(place.current, dark ? 'dark' : undefined);
      chart.setOption({
        backgroundColor: 'transparent',
        animation: false,
        textStyle: { fontFamily: 'inherit' },
        ...option,
      });
      chart.on('click', ({ name }) => pick.current?.(name));
      resize.observe(place.current);
    });
    return () => {
      disposed = true;
      resize.disconnect();
      chart?.dispose();
    };
  }, [arrived, option, dark]);
  return <div ref={place} role="img" aria-label={label} style={{ height }} />;
}
