import { createTheme, type MantineColorsTuple } from '@mantine/core';

const petrol: MantineColorsTuple = [
  '#e6f6f8',
  '#d3e9ec',
  '#a7d2d8',
  '#78bac3',
  '#52a6b2',
  '#3a9aa7',
  '#2a94a2',
  '#1a808d',
  '#0b6874',
  '#00525c',
];

/** The shades have a contrast of at least 4.5:1 in both colour schemes (WCAG AA). */
export const theme = createTheme({
  colors: { petrol },
  primaryColor: 'petrol',
  primaryShade: { light: 8, dark: 7 },
  autoContrast: true,
  // Dialogs and drawers appear at once for users who prefer reduced motion.
  respectReducedMotion: true,
  fontFamily: 'system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", Cantarell, sans-serif',
  fontFamilyMonospace: 'ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace',
});
