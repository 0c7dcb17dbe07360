package org.sitaf.server.access;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.sitaf.server.SitafServer;
import org.sitaf.server.support.Browser;
import org.sitaf.server.support.ServerTest;
import org.springframework.boot.SpringApplication;
import org.springframework.boot.test.system.CapturedOutput;
import org.springframework.boot.test.system.OutputCaptureExtension;
import org.springframework.boot.web.server.context.WebServerApplicationContext;
import org.springframework.context.ConfigurableApplicationContext;

/** The first password is stored in a private file until it is changed. */
@Tag("slow")
@ExtendWith(OutputCaptureExtension.class)
class FirstPasswordTest {
  @Test
  void firstPasswordIsInAPrivateFileUntilItIsChanged(CapturedOutput output) throws IOException {
    Path data = ServerTest.temporary();
    Files.setPosixFilePermissions(data, PosixFilePermissions.fromString("rwxr-xr-x"));
    try (ConfigurableApplicationContext server =
        SpringApplication.run(
            SitafServer.class,
            "--sitaf.data-directory=" + data,
            "--" + ServerTest.OWN_SCHEDULER + "first-password",
            "--server.port=0",
            "--spring.grpc.server.port=0")) {
      assertThat(server.getBean(AccessSettings.class).passwordStrength()).isEqualTo(12);
      Path file = data.resolve("first-password");
      assertThat(mode(data)).isEqualTo("rwx------");
      assertThat(mode(data.resolve("database.mv.db"))).isEqualTo("rw-------");
      assertThat(mode(file)).isEqualTo("rw-------");
      String password = Files.readString(file).strip();
      assertThat(output.getAll()).contains(file.toString()).doesNotContain(password);

      assertThat(server).isInstanceOf(WebServerApplicationContext.class);
      int port = server.getEnvironment().getRequiredProperty("local.server.port", Integer.class);
      Browser browser = new Browser(port);
      browser.signIn("administrator", password).expect(200);
      browser
          .send(
              "PUT",
              "/api/v1/session/password",
              "{\"current\":\"%s\",\"next\":\"correct horse battery staple\"}".formatted(password))
          .expect(204);
      assertThat(file).doesNotExist();
      new Browser(port).signIn("administrator", "correct horse battery staple").expect(200);
    }
  }

  private static String mode(Path path) throws IOException {
    return PosixFilePermissions.toString(Files.getPosixFilePermissions(path));
  }
}
