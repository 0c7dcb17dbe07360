import { afterEach, beforeEach } from 'vitest';
import { FakeServer } from './FakeServer';

/** A separate server for each test of a file. */
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
