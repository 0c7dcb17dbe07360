import {
  ActionIcon,
  Container,
  Group,
  useComputedColorScheme,
  useMantineColorScheme,
} from '@mantine/core';
import { Outlet } from '@tanstack/react-router';
import { AgentsStatus } from '@/features/agents';
import { RouteLink } from '@/shared/ui';
import { ConnectionBanner } from './ConnectionBanner';
import classes from './Shell.module.css';

/** The frame around every page. */
export function Shell() {
  return (
    <>
      <a className={classes.skip} href="#content">
        Skip to content
      </a>
      <header className={classes.header}>
        <Container size="xl">
          <Group justify="space-between" py="sm">
            <RouteLink to="/" className={classes.brand} underline="never" c="inherit">
              <img src="/favicon.svg" alt="" width={24} height={24} />
              SITAF
            </RouteLink>
            <Group gap="md">
              <AgentsStatus />
              <SchemeSwitch />
            </Group>
          </Group>
        </Container>
      </header>
      <ConnectionBanner />
      <Container component="main" size="xl" py="lg" id="content" tabIndex={-1}>
        <Outlet />
      </Container>
    </>
  );
}

function SchemeSwitch() {
  const { setColorScheme } = useMantineColorScheme();
  const dark = useComputedColorScheme('light') === 'dark';
  const label = dark ? 'Use light colours' : 'Use dark colours';
  return (
    <ActionIcon
      variant="default"
      size="lg"
      aria-label={label}
      title={label}
      onClick={() => {
        setColorScheme(dark ? 'light' : 'dark');
      }}
    >
      <span aria-hidden>{dark ? '☀' : '☾'}</span>
    </ActionIcon>
  );
}
