package org.sitaf.runtime.simulation;

import io.grpc.InsecureChannelCredentials;
import io.grpc.ManagedChannel;
import io.grpc.netty.shaded.io.grpc.netty.NettyChannelBuilder;
import io.grpc.netty.shaded.io.netty.channel.Channel;
import io.grpc.netty.shaded.io.netty.channel.EventLoopGroup;
import io.grpc.netty.shaded.io.netty.channel.epoll.Epoll;
import io.grpc.netty.shaded.io.netty.channel.epoll.EpollDomainSocketChannel;
import io.grpc.netty.shaded.io.netty.channel.epoll.EpollEventLoopGroup;
import io.grpc.netty.shaded.io.netty.channel.epoll.EpollSocketChannel;
import io.grpc.netty.shaded.io.netty.channel.nio.NioEventLoopGroup;
import io.grpc.netty.shaded.io.netty.channel.socket.nio.NioSocketChannel;
import io.grpc.netty.shaded.io.netty.channel.unix.DomainSocketAddress;
import io.grpc.netty.shaded.io.netty.util.concurrent.DefaultThreadFactory;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;
import java.util.logging.Level;
import java.util.logging.Logger;

/**
 * The connection to the simulator, with a thread of its own. gRPC's shared threads wait in native
 * code for a second after the last connection was closed, and the JVM lets its exit wait 0.3 s for
 * each thread that does.
 */
final class SimulatorChannel implements AutoCloseable {
  /** Name of the thread. */
  static final String THREAD = "sitaf-simulator";

  private static final int MAX_MESSAGE_BYTES = 64 << 20;
  private static final long END_MS = 500;

  /**
   * Netty logs a warning for every Unix socket, because it has no keep-alive. This logger
   * suppresses it; the field keeps a reference, because a collected logger loses its level.
   */
  private static final Logger SOCKET_OPTIONS =
      Logger.getLogger("io.grpc.netty.shaded.io.netty.bootstrap");

  static {
    SOCKET_OPTIONS.setLevel(Level.SEVERE);
    // Netty makes names of channels from them; to find them out takes longer than to connect, and
    // ends with a warning where there is no network.
    setUnlessSet("io.grpc.netty.shaded.io.netty.machineId", "00:00:00:00:00:00");
    setUnlessSet("io.grpc.netty.shaded.io.netty.processId", "1");
  }

  private final EventLoopGroup loop;
  private final ManagedChannel channel;

  /**
   * Connects at the first call.
   *
   * @param target {@code 127.0.0.1:PORT} or {@code unix:/absolute/path}
   */
  SimulatorChannel(String target) {
    boolean epoll = Epoll.isAvailable();
    ThreadFactory threads = new DefaultThreadFactory(THREAD, true);
    loop = epoll ? new EpollEventLoopGroup(1, threads) : new NioEventLoopGroup(1, threads);
    boolean unix = target.startsWith("unix:");
    Class<? extends Channel> type =
        !epoll
            ? NioSocketChannel.class
            : unix ? EpollDomainSocketChannel.class : EpollSocketChannel.class;
    Class<? extends SocketAddress> address =
        unix ? DomainSocketAddress.class : InetSocketAddress.class;
    channel =
        NettyChannelBuilder.forTarget(target, InsecureChannelCredentials.create())
            .eventLoopGroup(loop)
            .channelType(type, address)
            .proxyDetector(ignored -> null)
            .maxInboundMessageSize(MAX_MESSAGE_BYTES)
            .directExecutor()
            .build();
  }

  private static void setUnlessSet(String property, String value) {
    if (System.getProperty(property) == null) {
      System.setProperty(property, value);
    }
  }

  ManagedChannel channel() {
    return channel;
  }

  /** Ends the connection and its thread. */
  @Override
  public void close() {
    channel.shutdownNow();
    try {
      channel.awaitTermination(END_MS, TimeUnit.MILLISECONDS);
      loop.shutdownGracefully(0, 0, TimeUnit.MILLISECONDS);
      loop.awaitTermination(END_MS, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
