package org.sitaf.cli.system;

import java.io.IOException;
import java.net.BindException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.SecureRandom;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sitaf.cli.Installation;
import org.sitaf.cli.ProgressLine;

/**
 * A server and an agent, which starts a simulation of its own, on this machine and for this command
 * only.
 */
final class LocalSystem implements AutoCloseable {

  /** A machine may be busy with other things: who comes on, however slowly, is waited for. */
  private static final Patience PATIENCE =
      new Patience(Duration.ofMinutes(2), Duration.ofMinutes(20));

  private static final Pattern LISTENING = Pattern.compile("^listening http=(\\d+) grpc=(\\d+)");
  private static final Pattern REGISTERED = Pattern.compile("^registered ");
  private static final int SECRET_BYTES = 32;
  private static final SecureRandom RANDOM = new SecureRandom();

  private final StartedProcess server;
  private final StartedProcess agent;
  private final URI address;
  private final String token;

  private LocalSystem(StartedProcess server, StartedProcess agent, URI address, String token) {
    this.server = server;
    this.agent = agent;
    this.address = address;
    this.token = token;
  }

  /**
   * Starts both, and returns when the agent is registered.
   *
   * @param directory what server and agent keep; logs among it
   * @param httpPort 0 for a free one
   * @param grpcPort 0 for a free one
   * @throws IOException if one of them does not start; the message holds the end of its log
   */
  static LocalSystem start(
      Installation installation, Path directory, int httpPort, int grpcPort, ProgressLine progress)
      throws IOException, InterruptedException {
    createPrivate(directory);
    requireFree(httpPort, "--port");
    requireFree(grpcPort, "--grpc-port");
    progress.step("Starting the server");
    List<String> serverCommand = new ArrayList<>(installation.serverCommand());
    serverCommand.add("--sitaf.data-directory=" + directory.resolve("server"));
    serverCommand.add("--server.port=" + httpPort);
    serverCommand.add("--spring.grpc.server.port=" + grpcPort);
    serverCommand.add("--sitaf.stop-with-stdin=true");
    // On the loopback, for one person: who opened the portal once need not be asked for a month.
    serverCommand.add("--spring.session.timeout=30d");
    serverCommand.add("--server.servlet.session.cookie.max-age=30d");
    String token = secret();
    String enrolment = secret();
    StartedProcess server =
        new StartedProcess(
            "server",
            serverCommand,
            Map.of(
                "SITAF_ACCESS_LAUNCHERTOKEN", token, "SITAF_ACCESS_LAUNCHERENROLMENT", enrolment),
            directory.resolve("server.log"),
            LISTENING);
    try {
      Matcher ports = server.awaitReady(PATIENCE, progress);
      progress.step("Starting an agent");
      List<String> agentCommand = new ArrayList<>(installation.agentCommand());
      agentCommand.addAll(
          List.of(
              "--server",
              "127.0.0.1:" + ports.group(2),
              "--directory",
              directory.resolve("agent").toString(),
              "--stop-with-stdin"));
      StartedProcess agent =
          new StartedProcess(
              "agent",
              agentCommand,
              Map.of("SITAF_ENROLMENT_TOKEN", enrolment),
              directory.resolve("agent.log"),
              REGISTERED);
      try {
        agent.awaitReady(PATIENCE, progress, server);
        return new LocalSystem(
            server, agent, URI.create("http://localhost:" + ports.group(1)), token);
      } catch (IOException | InterruptedException e) {
        agent.close();
        throw e;
      }
    } catch (IOException | InterruptedException e) {
      server.close();
      throw e;
    }
  }

  /** Logs, results and keys are in it: other users of the machine do not read them. */
  private static void createPrivate(Path directory) throws IOException {
    Files.createDirectories(directory);
    if (Files.getFileStore(directory).supportsFileAttributeView("posix")) {
      Files.setPosixFilePermissions(directory, PosixFilePermissions.fromString("rwx------"));
    }
  }

  /** Better said in a sentence, and at once, than by the log of a server that does not start. */
  static void requireFree(int port, String option) throws IOException {
    if (port == 0) {
      return;
    }
    try (ServerSocket probe = new ServerSocket()) {
      probe.setReuseAddress(true);
      probe.bind(new InetSocketAddress(InetAddress.getByName("127.0.0.1"), port));
    } catch (BindException e) {
      throw new IOException(
          "port "
              + port
              + " is in use, perhaps by another './sitaf up': stop that one, or choose another port by "
              + option
              + " (0: a free one)",
          e);
    }
  }

  /** Where the portal and the REST interface are. */
  URI address() {
    return address;
  }

  /** The server's interface, for this command. */
  ServerClient client() {
    return new ServerClient(address, token);
  }

  /** An address that opens the portal signed in, once. */
  URI signInLink() throws IOException, InterruptedException {
    return address.resolve(client().post("session/link", Map.of()).path("path").asString());
  }

  private static String secret() {
    byte[] bytes = new byte[SECRET_BYTES];
    RANDOM.nextBytes(bytes);
    return HexFormat.of().formatHex(bytes);
  }

  /** Waits until the server ends, by itself or because this command is stopped. */
  int await() throws InterruptedException {
    return server.await();
  }

  @Override
  public void close() {
    agent.close();
    server.close();
  }
}
