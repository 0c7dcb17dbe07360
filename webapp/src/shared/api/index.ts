export { createApi, type ApiClient } from './client';
export { createConnection, type Connection, type ConnectionState } from './connection';
export { ServerContext, useApi, useConnectionState, useServer, type Server } from './context';
export { ApiError, ConnectionLostError, dataOf } from './errors';
export type * from './types';
