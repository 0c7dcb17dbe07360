import { useComputedColorScheme } from '@mantine/core';
import type { EChartsCoreOption, EChartsType } from 'echarts/core';
import { useEffect, useRef } from 'react';

interface ChartProps {
  /** What the graph says, in words: for those who do not see it. */
  label: string;
  option: EChartsCoreOption;
  height?: number;
  /** Called with the name of what was clicked. */
  onPick?: (name: string) => void;
}

/** A graph; its library is loaded with the first one that is shown. */
export function Chart({ label, option, height = 280, onPick }: ChartProps) {
  const place = useRef<HTMLDivElement>(null);
  const dark = useComputedColorScheme('light') === 'dark';
  const pick = useRef(onPick);
  useEffect(() => {
    pick.current = onPick;
  }, [onPick]);
  useEffect(() => {
    let chart: EChartsType | undefined;
    let gone = false;
    const resize = new ResizeObserver(() => chart?.resize());
    void import('./echarts').then(({ init }) => {
      if (gone || !place.current) return;
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
      gone = true;
      resize.disconnect();
      chart?.dispose();
    };
  }, [option, dark]);
  return <div ref={place} role="img" aria-label={label} style={{ height }} />;
}
