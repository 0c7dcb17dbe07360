/** `lost` if the last request got no response at all. */
export type ConnectionState = 'up' | 'lost';

export interface Connection {
  readonly state: () => ConnectionState;
  /** Called after each request; `answered` if a response came, whatever its status. */
  readonly report: (answered: boolean) => void;
  readonly subscribe: (listener: () => void) => () => void;
}

export function createConnection(): Connection {
  let current: ConnectionState = 'up';
  const listeners = new Set<() => void>();
  return {
    state: () => current,
    report(answered) {
      const next = answered ? 'up' : 'lost';
      if (next === current) return;
      current = next;
      for (const listener of listeners) listener();
    },
    subscribe(listener) {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  };
}
