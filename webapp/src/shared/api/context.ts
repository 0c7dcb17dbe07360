import { createContext, useContext, useSyncExternalStore } from 'react';
import type { ApiClient } from './client';
import type { Connection, ConnectionState } from './connection';

export interface Server {
  readonly api: ApiClient;
  readonly connection: Connection;
}

export const ServerContext = createContext<Server | null>(null);

export function useServer(): Server {
  const server = useContext(ServerContext);
  if (!server) throw new Error('useServer needs a ServerContext above it');
  return server;
}

export function useApi(): ApiClient {
  return useServer().api;
}

export function useConnectionState(): ConnectionState {
  const { connection } = useServer();
  return useSyncExternalStore(connection.subscribe, connection.state);
}
