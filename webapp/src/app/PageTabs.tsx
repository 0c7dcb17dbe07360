import { Tabs } from '@mantine/core';
import type { ReactNode } from 'react';

export interface PageTab<T extends string> {
  value: T;
  label: string;
  content: () => ReactNode;
}

interface PageTabsProps<T extends string> {
  label: string;
  tabs: readonly PageTab<T>[];
  value: T;
  onTab: (tab: T) => void;
}

/** The tabs of a page. Each tab has an address; only the selected tab is rendered. */
export function PageTabs<T extends string>({ label, tabs, value, onTab }: PageTabsProps<T>) {
  return (
    <Tabs
      value={value}
      keepMounted={false}
      onChange={(next) => {
        const tab = tabs.find((known) => known.value === next);
        if (tab) onTab(tab.value);
      }}
    >
      <Tabs.List aria-label={label}>
        {tabs.map((tab) => (
          <Tabs.Tab key={tab.value} value={tab.value}>
            {tab.label}
          </Tabs.Tab>
        ))}
      </Tabs.List>
      {tabs.map((tab) => (
        <Tabs.Panel key={tab.value} value={tab.value} pt="lg">
          {tab.value === value && tab.content()}
        </Tabs.Panel>
      ))}
    </Tabs>
  );
}
