import { Container } from '@mantine/core';
import { useEffect } from 'react';
import { useApi, useConnectionState } from '@/shared/api';
import classes from './Shell.module.css';

const PROBE_MS = 2_000;

/** Shown while the server does not respond. */
export function ConnectionBanner() {
  const lost = useConnectionState() === 'lost';
  useProbe(lost);
  return (
    <div role="alert">
      {lost && (
        <div className={classes.lost}>
          <Container size="xl">
            <strong>No connection to the server.</strong> This page may be out of date. The portal
            tries to reconnect.
          </Container>
        </div>
      )}
    </div>
  );
}

/** Sends requests while the connection is lost, so that the portal notices when it is back. */
function useProbe(active: boolean) {
  const api = useApi();
  useEffect(() => {
    if (!active) return undefined;
    const timer = setInterval(() => {
      api.GET('/api/v1/agents').catch(() => {
        // Still lost, and already reported.
      });
    }, PROBE_MS);
    return () => {
      clearInterval(timer);
    };
  }, [active, api]);
}
