import '@mantine/core/styles.css';
import { MantineProvider } from '@mantine/core';
import { StrictMode } from 'react';
import { createRoot } from 'react-dom/client';
import { theme } from '@/app/theme';
import '@/app/theme.css';
import { LiveCase } from './LiveCase';

const root = document.getElementById('root');
if (!root) throw new Error('live.html has no element #root');

createRoot(root).render(
  <StrictMode>
    <MantineProvider theme={theme} defaultColorScheme="auto">
      <LiveCase />
    </MantineProvider>
  </StrictMode>,
);
