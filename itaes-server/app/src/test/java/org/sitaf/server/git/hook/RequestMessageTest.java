package org.sitaf.server.git.hook;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.git.request.ReportedRequest;
import org.sitaf.server.git.source.Forge;
import tools.jackson.databind.json.JsonMapper;

class RequestMessageTest {
  private static final String HEAD = "0123456789abcdef0123456789abcdef01234567";
  private static final String PULL =
      """
      {"action": "opened", "pull_request": {"number": 7, "state": "open", "title": "Add a range",
       "user": {"login": "octocat"}, "head": {"sha": "%s", "repo": {"id": 7}},
       "base": {"ref": "main", "repo": {"id": 7, "full_name": "robots/sensors"}}}}"""
          .formatted(HEAD);
  private static final String MERGE =
      """
      {"user": {"name": "Octo Cat"}, "object_attributes": {"action": "open", "iid": 7,
       "state": "opened", "title": "Add a range", "target_branch": "main",
       "source_project_id": 7, "target_project_id": 7,
       "target": {"path_with_namespace": "robots/sensors"}, "last_commit": {"id": "%s"}}}"""
          .formatted(HEAD);

  private static ReportedRequest parse(Forge forge, String message) {
    return RequestMessage.parse(forge, JsonMapper.shared().readTree(message)).orElseThrow();
  }

  @Test
  void messagesOfAllForgesSayTheSame() {
    assertThat(parse(Forge.GITHUB, PULL))
        .isEqualTo(
            new ReportedRequest(
                Forge.GITHUB,
                7,
                "Add a range",
                "octocat",
                HEAD,
                "robots/sensors",
                "main",
                false,
                true));
    assertThat(parse(Forge.GITEA, PULL).forge()).isEqualTo(Forge.GITEA);
    assertThat(parse(Forge.GITLAB, MERGE))
        .isEqualTo(
            new ReportedRequest(
                Forge.GITLAB,
                7,
                "Add a range",
                "Octo Cat",
                HEAD,
                "robots/sensors",
                "main",
                false,
                true));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "\"repo\": {\"id\": 8}",
        "\"repo\": null",
        "\"repo\": {}",
        "\"repo\": {\"id\": \"7\"}",
        "\"repo\": {\"id\": 7.0}",
        "\"other\": 1"
      })
  void aPullRequestOfWhichTheRepositoryIsNotTheSameIsAFork(String repository) {
    String message = PULL.replace("\"repo\": {\"id\": 7}}", repository + "}");
    assertThat(parse(Forge.GITHUB, message).fork()).isTrue();
  }

  @ParameterizedTest
  @ValueSource(strings = {"\"source_project_id\": 8", "\"source_project_id\": null", "\"x\": 7"})
  void aMergeRequestOfWhichTheProjectIsNotTheSameIsAFork(String project) {
    String message = MERGE.replace("\"source_project_id\": 7", project);
    assertThat(parse(Forge.GITLAB, message).fork()).isTrue();
  }

  @Test
  void aRequestOfTwoUnknownRepositoriesIsAFork() {
    assertThat(parse(Forge.GITHUB, PULL.replace("\"id\": 7", "\"id\": null")).fork()).isTrue();
    assertThat(parse(Forge.GITLAB, MERGE.replace("project_id\": 7", "project_id\": null")).fork())
        .isTrue();
  }

  @ParameterizedTest
  @CsvSource({
    "opened, true",
    "synchronize, true",
    "synchronized, true",
    "reopened, true",
    "edited, true",
    "closed, false"
  })
  void actionsOfPullRequestsSayWhetherTheyAreOpen(String action, boolean open) {
    String message = PULL.replace("\"opened\"", "\"" + action + "\"");
    assertThat(parse(Forge.GITHUB, message).open()).isEqualTo(open);
    assertThat(parse(Forge.GITHUB, message.replace("\"open\"", "\"closed\"")).open()).isFalse();
  }

  @ParameterizedTest
  @CsvSource({
    "open, opened, true",
    "update, opened, true",
    "reopen, opened, true",
    "update, closed, false",
    "close, closed, false",
    "merge, merged, false"
  })
  void actionsOfMergeRequestsSayWhetherTheyAreOpen(String action, String state, boolean open) {
    String message =
        MERGE.replace("\"open\"", "\"" + action + "\"").replace("\"opened\"", "\"" + state + "\"");
    assertThat(parse(Forge.GITLAB, message).open()).isEqualTo(open);
  }

  @Test
  void otherActionsAreIgnored() {
    assertThat(
            RequestMessage.parse(
                Forge.GITHUB,
                JsonMapper.shared().readTree(PULL.replace("\"opened\"", "\"labeled\""))))
        .isEmpty();
    assertThat(
            RequestMessage.parse(
                Forge.GITLAB,
                JsonMapper.shared().readTree(MERGE.replace("\"open\"", "\"approved\""))))
        .isEmpty();
    assertThat(RequestMessage.parse(Forge.GITHUB, JsonMapper.shared().readTree("[]"))).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(strings = {"0", "-7", "7.5", "99999999999", "\"7\"", "null", "[7]"})
  void aNumberMustBePositive(String number) {
    assertThatThrownBy(
            () -> parse(Forge.GITHUB, PULL.replace("\"number\": 7", "\"number\": " + number)))
        .isInstanceOf(RequestException.class)
        .hasMessageContaining("positive number");
    assertThatThrownBy(() -> parse(Forge.GITLAB, MERGE.replace("\"iid\": 7", "\"iid\": " + number)))
        .isInstanceOf(RequestException.class)
        .hasMessageContaining("positive number");
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "main", "0123456789ABCDEF0123456789abcdef01234567", "0123 "})
  void aHeadMustBeTheIdOfACommit(String head) {
    assertThatThrownBy(() -> parse(Forge.GITHUB, PULL.replace(HEAD, head)))
        .isInstanceOf(RequestException.class)
        .hasMessageContaining("40 lower-case hexadecimal digits");
  }
}
