import { createMemoryHistory } from '@tanstack/react-router';
import { render } from '@testing-library/react';
import userEvent from '@testing-library/user-event';
import { Portal } from '@/app/Portal';
import { createApi, createConnection } from '@/shared/api';
import type { FakeServer } from './FakeServer';

/** Opens the portal at an address. */
export function openPortal(server: FakeServer, address = '/') {
  const connection = createConnection();
  const history = createMemoryHistory({ initialEntries: [address] });
  const api = createApi(server.url, connection);
  const view = render(<Portal server={{ api, connection }} history={history} />);
  return { ...view, history, user: userEvent.setup({ pointerEventsCheck: 0 }) };
}
