import { Container } from '@mantine/core';
import { useEffect } from 'react';
import { useApi, useConnectionState } from '@/shared/api';
import classes from './Shell.module.css';

const PROBE_MS = 2_000;

/** Says that the server does not answer, and asks until it does. */
export function ConnectionBanner() {
  const lost = useConnectionState() === 'lost';
  useProbe(lost);
  return (
    <div role="alert">
      {lost && (
        <div className={classes.lost}>
          <Container size="xl">
            <strong>No connection to the server.</strong> What you see may be out of date; the
            portal keeps trying.
          </Container>
        </div>
      )}
    </div>
  );
}

/** Any request tells the connection how it went; while nothing else asks, this one does. */
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
