package org.sitaf.agent.manager;

import io.grpc.EquivalentAddressGroup;
import io.grpc.NameResolver;
import io.grpc.NameResolverProvider;
import io.grpc.NameResolverRegistry;
import io.grpc.StatusOr;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.net.URI;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.Set;

/**
 * Resolves several servers with one database, HOST:PORT joined by commas. The agent connects to the
 * first one that answers. Each agent shuffles the addresses to distribute the load.
 */
final class ServerAddresses extends NameResolverProvider {
  private static final String SCHEME = "sitaf-servers";
  private static final int PRIORITY = 5;

  static {
    NameResolverRegistry.getDefaultRegistry().register(new ServerAddresses());
  }

  /** The gRPC target of one or several servers. */
  static String target(String servers) {
    if (!servers.contains(",")) {
      return servers;
    }
    List<String> order = new ArrayList<>(List.of(servers.split("\\s*,\\s*")));
    order.forEach(ServerAddresses::parse);
    Collections.shuffle(order);
    return SCHEME + ":///" + String.join(",", order);
  }

  private static InetSocketAddress parse(String server) {
    int colon = server.lastIndexOf(':');
    try {
      return new InetSocketAddress(
          server.substring(0, Math.max(0, colon)), Integer.parseInt(server.substring(colon + 1)));
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException("--server '" + server + "': expected HOST:PORT", e);
    }
  }

  @Override
  protected boolean isAvailable() {
    return true;
  }

  @Override
  protected int priority() {
    return PRIORITY;
  }

  @Override
  public String getDefaultScheme() {
    return SCHEME;
  }

  @Override
  public Collection<Class<? extends SocketAddress>> getProducedSocketAddressTypes() {
    return Set.of(InetSocketAddress.class);
  }

  @Override
  public NameResolver newNameResolver(URI target, NameResolver.Args arguments) {
    List<String> servers = List.of(target.getPath().substring(1).split(","));
    return new NameResolver() {
      @Override
      public String getServiceAuthority() {
        return servers.get(0);
      }

      @Override
      public void start(Listener2 listener) {
        // Host names are resolved each time, because a server may have moved.
        List<EquivalentAddressGroup> addresses =
            servers.stream().map(server -> new EquivalentAddressGroup(parse(server))).toList();
        listener.onResult(
            ResolutionResult.newBuilder()
                .setAddressesOrError(StatusOr.fromValue(addresses))
                .build());
      }

      @Override
      public void shutdown() {
        // Nothing to release.
      }
    };
  }
}
