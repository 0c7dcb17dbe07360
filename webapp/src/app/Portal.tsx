import '@mantine/core/styles.css';
import { MantineProvider } from '@mantine/core';
import { QueryCache, QueryClient, QueryClientProvider } from '@tanstack/react-query';
import { RouterProvider, type RouterHistory } from '@tanstack/react-router';
import { useEffect, useState } from 'react';
import { ApiError, ServerContext, type Server } from '@/shared/api';
import { createPortalRouter } from './router';
import { theme } from './theme';
import './theme.css';

interface PortalProps {
  server: Server;
  history?: RouterHistory;
}

/** The portal for one server. */
export function Portal({ server, history }: PortalProps) {
  const [router] = useState(() => createPortalRouter(history));
  const [queries] = useState(createQueryClient);
  useEffect(() => refreshWhenReconnected(server, queries), [server, queries]);
  return (
    <MantineProvider theme={theme} defaultColorScheme="auto">
      <ServerContext value={server}>
        <QueryClientProvider client={queries}>
          <RouterProvider router={router} />
        </QueryClientProvider>
      </ServerContext>
    </MantineProvider>
  );
}

function createQueryClient(): QueryClient {
  const queries = new QueryClient({
    queryCache: new QueryCache({
      onError: (error) => {
        // The session has ended: the shell redirects to the sign-in page.
        if (error instanceof ApiError && error.status === 401) {
          void queries.invalidateQueries({ queryKey: ['session'] });
        }
      },
    }),
    defaultOptions: {
      // No retries: rejected requests stay rejected, and all queries are repeated after a reconnect (below).
      // The online state of the browser does not depend on a server on this machine.
      queries: { retry: false, networkMode: 'always' },
      mutations: { retry: false, networkMode: 'always' },
    },
  });
  return queries;
}

/** Data may be outdated after a lost connection, so all queries are repeated. */
function refreshWhenReconnected({ connection }: Server, queries: QueryClient): () => void {
  return connection.subscribe(() => {
    if (connection.state() === 'up') void queries.invalidateQueries();
  });
}
