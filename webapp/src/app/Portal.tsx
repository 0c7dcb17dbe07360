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

/** The whole portal on one server. */
export function Portal({ server, history }: PortalProps) {
  const [router] = useState(() => createPortalRouter(history));
  const [queries] = useState(createQueryClient);
  useEffect(() => refreshWhenHealed(server, queries), [server, queries]);
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
        // The session has ended: the frame shows the way in.
        if (error instanceof ApiError && error.status === 401) {
          void queries.invalidateQueries({ queryKey: ['session'] });
        }
      },
    }),
    defaultOptions: {
      // A refusal stays one, and a lost connection heals for all queries at once (below).
      // The browser's own idea of being online says nothing of a server on this machine.
      queries: { retry: false, networkMode: 'always' },
      mutations: { retry: false, networkMode: 'always' },
    },
  });
  return queries;
}

/** What was shown while the connection was lost may be old: everything is asked for again. */
function refreshWhenHealed({ connection }: Server, queries: QueryClient): () => void {
  return connection.subscribe(() => {
    if (connection.state() === 'up') void queries.invalidateQueries();
  });
}
