import { afterEach, beforeEach } from 'vitest';
import { FakeServer } from './FakeServer';

/** A server of its own for each test of the file. */
export function eachWithServer(give: (server: FakeServer) => void) {
  let server: FakeServer;

  beforeEach(async () => {
    server = new FakeServer();
    await server.start();
    give(server);
  });

  afterEach(async () => {
    await server.stop();
  });
}
