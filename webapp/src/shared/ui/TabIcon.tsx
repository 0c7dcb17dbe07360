import { useEffect } from 'react';

const ICONS = {
  good: '/favicon.svg',
  bad: '/favicon-bad.svg',
  active: '/favicon-active.svg',
  waiting: '/favicon-active.svg',
  neutral: '/favicon.svg',
} as const;

/** Shows the state of a build in the icon of the browser's tab, while it is rendered. */
export function TabIcon({ tone }: { tone: keyof typeof ICONS }) {
  useEffect(() => {
    const icon = document.querySelector<HTMLLinkElement>('link[rel="icon"]');
    if (!icon) return;
    icon.href = ICONS[tone];
    return () => {
      icon.href = ICONS.neutral;
    };
  }, [tone]);
  return null;
}
