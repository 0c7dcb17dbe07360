package org.sitaf.server.web;

import java.util.HashMap;
import java.util.Map;
import org.springframework.stereotype.Component;

/**
 * Permits for waiting for request bodies. A waiting request blocks a thread, so there are fewer
 * permits than threads, and limits per client.
 */
@Component
class BodyPermits {
  private static final int MAX_ANONYMOUS = 32;
  private static final int MAX_PER_ADDRESS = 8;
  private static final int MAX_AUTHENTICATED = 96;
  private static final int MAX_PER_CALLER = 12;

  private final Map<Client, Integer> taken = new HashMap<>();
  private int anonymous;
  private int authenticated;

  /**
   * The sender of a body.
   *
   * @param name of the caller; the address if the request is not authenticated
   */
  record Client(String name, boolean anonymous) {}

  synchronized boolean tryAcquire(Client client) {
    int own = taken.getOrDefault(client, 0);
    boolean free =
        client.anonymous()
            ? anonymous < MAX_ANONYMOUS && own < MAX_PER_ADDRESS
            : authenticated < MAX_AUTHENTICATED && own < MAX_PER_CALLER;
    if (free) {
      taken.put(client, own + 1);
      add(client, 1);
    }
    return free;
  }

  synchronized void release(Client client) {
    taken.computeIfPresent(client, (key, own) -> own == 1 ? null : own - 1);
    add(client, -1);
  }

  private void add(Client client, int count) {
    if (client.anonymous()) {
      anonymous += count;
    } else {
      authenticated += count;
    }
  }
}
