import {
  ActionIcon,
  Anchor,
  Button,
  Container,
  Group,
  Text,
  useComputedColorScheme,
  useMantineColorScheme,
} from '@mantine/core';
import { Link, Outlet, useLocation, useNavigate } from '@tanstack/react-router';
import { Suspense, useEffect } from 'react';
import { AgentsStatus } from '@/features/agents';
import { useSession, useSignOut } from '@/features/session';
import { visible } from '@/shared/lib/visible';
import { Loading, RouteLink, UserText } from '@/shared/ui';
import { ConnectionBanner } from './ConnectionBanner';
import classes from './Shell.module.css';
import { WholePage } from './WholePage';

const NAVIGATION = [
  // The page of a suite belongs to its activity.
  { to: '/activities', label: 'Activities', also: '/suites/' },
  { to: '/builds', label: 'Builds' },
  { to: '/schedules', label: 'Schedules' },
  { to: '/agents', label: 'Agents' },
  { to: '/settings', label: 'Settings' },
] as const;

/** The header of every page. Redirects to the sign-in page if signedOut is signed in. */
export function Shell() {
  const session = useSession();
  const navigate = useNavigate();
  const { pathname, href } = useLocation();
  const onSignInPage = pathname === '/sign-in';
  const signedOut = session.data === null;
  useEffect(() => {
    if (signedOut && !onSignInPage) {
      void navigate({ to: '/sign-in', search: href === '/' ? {} : { to: href }, replace: true });
    }
  }, [signedOut, onSignInPage, href, navigate]);
  return (
    <>
      <a className={classes.skip} href="#content">
        Skip to content
      </a>
      <header className={classes.header}>
        <Container size="xl">
          <div className={classes.bar}>
            <RouteLink to="/" className={classes.brand} underline="never" c="inherit">
              <img src="/favicon.svg" alt="" width={24} height={24} />
              SITAF
            </RouteLink>
            <nav aria-label="Main" className={classes.navigation} hidden={signedOut}>
              {NAVIGATION.map(({ to, label, ...item }) => (
                <Link
                  key={to}
                  to={to}
                  className={classes.navigationItem}
                  {...('also' in item &&
                    pathname.startsWith(item.also) && { 'aria-current': 'page' as const })}
                  activeProps={{ 'aria-current': 'page' }}
                >
                  {label}
                </Link>
              ))}
            </nav>
            <div className={classes.status}>{session.data && <AgentsStatus />}</div>
            <Group gap="md" wrap="nowrap" className={classes.account ?? ''}>
              <Anchor href="/docs/index.html" target="_blank" size="sm" c="inherit">
                Documentation
              </Anchor>
              {session.data && <Account name={session.data.name} />}
              <SchemeSwitch />
            </Group>
          </div>
        </Container>
      </header>
      <ConnectionBanner />
      <Container component="main" size="xl" py="lg" id="content" tabIndex={-1}>
        <Suspense fallback={<Loading what="the page" />}>
          {(session.data !== null || onSignInPage) && (
            <WholePage>
              <Outlet />
            </WholePage>
          )}
        </Suspense>
      </Container>
    </>
  );
}

function Account({ name }: { name: string }) {
  const signOut = useSignOut();
  return (
    <Group gap="xs" wrap="nowrap">
      <Text size="sm" className={classes.name ?? ''}>
        <UserText>{name}</UserText>
      </Text>
      <Button
        size="compact-sm"
        variant="default"
        title={`Signed in as ${visible(name)}`}
        loading={signOut.isPending}
        onClick={() => {
          signOut.mutate();
        }}
      >
        Sign out
      </Button>
    </Group>
  );
}

function SchemeSwitch() {
  const { setColorScheme } = useMantineColorScheme();
  const dark = useComputedColorScheme('light') === 'dark';
  const label = dark ? 'Switch to light mode' : 'Switch to dark mode';
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
