package org.sitaf.server.support;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.UUID;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.sitaf.server.SitafServer;
import org.springframework.beans.factory.annotation.Autowired;
import org.springframework.boot.test.context.SpringBootTest;
import org.springframework.boot.test.context.SpringBootTest.WebEnvironment;
import org.springframework.boot.test.web.server.LocalServerPort;
import org.springframework.grpc.server.lifecycle.GrpcServerLifecycle;
import org.springframework.test.context.DynamicPropertyRegistry;
import org.springframework.test.context.DynamicPropertySource;

/** A server on free ports with an H2 database; tests with equal properties share it. */
@SpringBootTest(
    classes = SitafServer.class,
    webEnvironment = WebEnvironment.RANDOM_PORT,
    properties = {
      "spring.grpc.server.port=0",
      // As weak as allowed: the tests sign in hundreds of times.
      "sitaf.access.password-strength=10",
      // An agent of a test that sends nothing meanwhile is disconnected.
      "sitaf.lease=10s",
      "sitaf.retry-delay=50ms",
      "sitaf.max-log=64KB",
      "sitaf.max-recordings=1MB",
      "sitaf.max-signals=100KB",
      "sitaf.webhooks.allowed-hosts=localhost",
      "sitaf.webhooks.private-addresses=true",
      "sitaf.webhooks.interval=200ms",
      "sitaf.git.private-addresses=true",
      "sitaf.git.plain-http-hosts=localhost",
      "sitaf.git.min-interval=1s",
      "sitaf.git.status-interval=100ms",
      "sitaf.git.max-object=4MB",
      "sitaf.git.max-repository=16MB"
    })
@Tag("slow")
public abstract class ServerTest {
  /** The launcher's token, with the role of an administrator. */
  public static final String TOKEN = "launcher-token-of-the-tests-0123456789";

  /** The launcher's enrolment token for agents. */
  public static final String ENROLMENT = "launcher-enrolment-of-the-tests-012345";

  /**
   * Names the scheduler of a server that does not share the others' properties. Quartz keeps data
   * sources by this name in a static field, so a second server of the same name that is closed
   * would leave the first one without a database.
   */
  public static final String OWN_SCHEDULER = "spring.quartz.scheduler-name=";

  private static final Path DATA = temporary();

  /** Repositories below it may be fetched by file: URLs. */
  protected static final Path REPOSITORIES = temporary();

  @LocalServerPort private int httpPort;
  @Autowired private GrpcServerLifecycle grpc;

  protected Api api = new Api(0);

  @DynamicPropertySource
  static void dataDirectory(DynamicPropertyRegistry registry) {
    registry.add("sitaf.data-directory", DATA::toString);
    registry.add("sitaf.git.file-folders", REPOSITORIES::toString);
    registry.add("sitaf.access.launcher-token", () -> TOKEN);
    registry.add("sitaf.access.launcher-enrolment", () -> ENROLMENT);
  }

  @BeforeEach
  void connect() {
    api = new Api(httpPort);
  }

  /** The data directory of the shared server. */
  protected static Path data() {
    return DATA;
  }

  protected int httpPort() {
    return httpPort;
  }

  protected int grpcPort() {
    return grpc.getPort();
  }

  /** The token of a new user with a role. */
  protected String tokenOf(String role) {
    String name = role.toLowerCase(Locale.ROOT) + "-" + UUID.randomUUID();
    String password =
        api.post("/api/v1/users", "{\"name\":\"%s\",\"role\":\"%s\"}".formatted(name, role))
            .expect(201)
            .json()
            .get("password")
            .asString();
    Browser browser = new Browser(httpPort);
    browser.signIn(name, password).expect(200);
    return browser
        .send(
            "POST",
            "/api/v1/tokens",
            "{\"name\":\"of a test\",\"role\":\"%s\",\"days\":1}".formatted(role))
        .expect(201)
        .json()
        .get("secret")
        .asString();
  }

  public static Path temporary() {
    try {
      return Files.createTempDirectory(Path.of("target").toAbsolutePath(), "server-");
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }
}
