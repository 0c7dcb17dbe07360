package org.sitaf.server.git.request;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sitaf.server.git.source.Forge;
import org.sitaf.server.git.source.ForgeProject;
import org.sitaf.server.git.source.GitSource;

class ReportedRequestTest {
  private static ReportedRequest request(String title, String repository) {
    return new ReportedRequest(
        Forge.GITHUB, 1, title, "a", "0".repeat(40), repository, "main", false, true);
  }

  private static GitSource source(String url, @Nullable ForgeProject project) {
    return new GitSource(
        "s",
        "a",
        url,
        "main",
        "",
        GitSource.CredentialKind.NONE,
        "",
        null,
        null,
        GitSource.Policy.LATEST,
        300,
        0,
        Instant.EPOCH,
        null,
        null,
        null,
        null,
        project,
        null,
        null);
  }

  @ParameterizedTest
  @CsvSource({
    "https://github.com/robots/sensors.git, robots/sensors, true",
    "https://github.com/Robots/sensors/, robots/Sensors, true",
    "git@github.com:robots/sensors.git, robots/sensors, true",
    "https://host/gitlab/group/robots/sensors, group/robots/sensors, true",
    "https://github.com/robots/sensors, other/sensors, false",
    "https://github.com/robots/sensors, sensors, false",
    "https://github.com/my-robots/sensors, robots/sensors, false",
    "https://github.com/robots/sensors, '', false"
  })
  void theRepositoryIsThatOfTheUrl(String url, String repository, boolean concerns) {
    assertThat(request("", repository).concerns(source(url, null))).isEqualTo(concerns);
  }

  @Test
  void theProjectAtTheForgeComesBeforeTheUrl() {
    GitSource source =
        source(
            "https://mirror/other/path",
            new ForgeProject(Forge.GITHUB, "https://api.github.com", "robots/sensors"));
    assertThat(request("", "robots/sensors").concerns(source)).isTrue();
    assertThat(request("", "other/path").concerns(source)).isFalse();
    GitSource atGitLab =
        source(
            "https://host/robots/sensors",
            new ForgeProject(Forge.GITLAB, "https://host/api/v4", "robots/sensors"));
    assertThat(request("", "robots/sensors").concerns(atGitLab)).isFalse();
  }

  @Test
  void titlesArePlainAndShort() {
    assertThat(request("a\u0000b\u001b[1m\u202ec\ud800", "").title()).isEqualTo("a b [1m c ");
    String smiles = "x".repeat(198) + "\ud83d\ude00".repeat(5);
    assertThat(request(smiles, "").title()).isEqualTo("x".repeat(198) + "…");
    assertThat(request("y".repeat(200), "").title()).hasSize(200).doesNotContain("…");
  }
}
