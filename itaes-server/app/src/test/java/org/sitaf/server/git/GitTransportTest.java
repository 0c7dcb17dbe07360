package org.sitaf.server.git;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.KeyPair;
import java.security.KeyPairGenerator;
import java.util.Base64;
import org.apache.sshd.common.config.keys.KeyUtils;
import org.apache.sshd.common.keyprovider.KeyPairProvider;
import org.apache.sshd.server.SshServer;
import org.apache.sshd.server.shell.ProcessShellCommandFactory;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sitaf.server.support.GitHttpServer;
import org.springframework.beans.factory.annotation.Autowired;
import org.springframework.jdbc.core.simple.JdbcClient;
import tools.jackson.databind.JsonNode;

/** Repositories are fetched by smart HTTP and SSH, with credentials that nobody sees again. */
@Tag("slow")
class GitTransportTest extends GitStory {
  private static final String SECRET = "glpat-not-to-be-seen";

  @Autowired private JdbcClient jdbc;

  private String token(GitHttpServer server, String secret) {
    return settings(
        server.url(repository.folder().getFileName().toString()),
        ", \"credential\": \"TOKEN\", \"user\": \"bot\", \"secret\": \"" + secret + "\"");
  }

  @Test
  void aTokenFetchesByHttpUntilItExpires() throws IOException {
    String first = repository.commit("One");
    try (GitHttpServer server = new GitHttpServer(REPOSITORIES, "bot", SECRET)) {
      assertThat(api.post("/api/v1/git-activities", token(server, "wrong")).expect(409).text())
          .contains("The credential was refused")
          .contains("Enter a new one")
          .doesNotContain("wrong,");
      String activity = api.post("/api/v1/git-activities", token(server, SECRET)).expect(201).id();
      await(activity, first, "DONE");
      String path = "/api/v1/activities/" + activity + "/git";
      assertThat(api.get(path).text()).contains("\"bot\"").doesNotContain(SECRET);
      String stored =
          jdbc.sql("SELECT secret FROM git_source WHERE activity_id = ?")
              .param(activity)
              .query(String.class)
              .single();
      assertThat(new String(Base64.getDecoder().decode(stored), StandardCharsets.ISO_8859_1))
          .doesNotContain(SECRET);
      Path key = data().resolve("git.key");
      assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(key)))
          .isEqualTo("rw-------");

      server.expect("bot", "renewed");
      fetch(activity);
      JsonNode failed = await(path, source -> source.has("problem"));
      assertThat(failed.get("problem").asString()).contains("expired");
      api.put(
              path,
              "application/json",
              token(server, "renewed").getBytes(StandardCharsets.UTF_8),
              "*")
          .expect(200);
      await(path, source -> !source.has("problem") && source.has("fetched"));

      // The stored secret is kept for the same host, and is not sent to another one.
      String kept = token(server, "").replace("\"secret\": \"\"", "\"secret\": null");
      api.put(path, "application/json", kept.getBytes(StandardCharsets.UTF_8), "\"1\"").expect(200);
      api.put(path, "application/json", kept.getBytes(StandardCharsets.UTF_8), "\"1\"").expect(412);
      assertThat(
              api.put(
                      path,
                      "application/json",
                      kept.replace("http://localhost", "https://forge.example.org")
                          .replaceAll("org:\\d+", "org")
                          .getBytes(StandardCharsets.UTF_8),
                      "*")
                  .expect(400)
                  .text())
          .contains("secret: must be given");
    }
  }

  @Test
  void aDeployKeyFetchesBySshFromTheHostThatIsKnown() throws Exception {
    String first = repository.commit("One");
    KeyPairGenerator generator = KeyPairGenerator.getInstance("RSA");
    generator.initialize(2048);
    KeyPair deployKey = generator.generateKeyPair();
    String pem =
        "-----BEGIN PRIVATE KEY-----\n"
            + Base64.getMimeEncoder(64, new byte[] {'\n'})
                .encodeToString(deployKey.getPrivate().getEncoded())
            + "\n-----END PRIVATE KEY-----\n";
    String escaped = pem.replace("\n", "\\n");
    try (SshServer server = SshServer.setUpDefaultServer()) {
      server.setHost("127.0.0.1");
      server.setKeyPairProvider(KeyPairProvider.wrap(generator.generateKeyPair()));
      server.setPublickeyAuthenticator(
          (user, key, session) -> KeyUtils.compareKeys(key, deployKey.getPublic()));
      server.setCommandFactory(ProcessShellCommandFactory.INSTANCE);
      server.start();
      String url = "ssh://git@localhost:" + server.getPort() + repository.folder();
      assertThat(api.post("/api/v1/git-activities", settings(url, "")).expect(400).text())
          .contains("needs a deploy key");
      assertThat(
              api.post(
                      "/api/v1/git-activities",
                      settings(url, ", \"credential\": \"DEPLOY_KEY\", \"secret\": \"no key\""))
                  .expect(400)
                  .text())
          .contains("ssh-keygen");
      String activity =
          api.post(
                  "/api/v1/git-activities",
                  settings(
                      url, ", \"credential\": \"DEPLOY_KEY\", \"secret\": \"" + escaped + "\""))
              .expect(201)
              .id();
      await(activity, first, "DONE");
      String path = "/api/v1/activities/" + activity + "/git";
      assertThat(get(path).get("hostKey").asString()).startsWith("SHA256:");

      server.setKeyPairProvider(KeyPairProvider.wrap(generator.generateKeyPair()));
      fetch(activity);
      assertThat(await(path, source -> source.has("problem")).get("problem").asString())
          .contains("has another key");
    }
  }
}
