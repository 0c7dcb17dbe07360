package org.sitaf.agent;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

class AgentMainTest {
  @Test
  void splitsACommandAndKeepsQuotedWords() {
    assertThat(AgentMain.words("python -m  sitaf_bridge"))
        .containsExactly("python", "-m", "sitaf_bridge");
    assertThat(AgentMain.words("'/a folder/python' -m \"x y\"'z'"))
        .containsExactly("/a folder/python", "-m", "x yz");
    assertThat(AgentMain.words("a ''")).containsExactly("a", "");
    assertThat(AgentMain.words("  ")).isEmpty();
  }

  @Test
  void reportsAnUnclosedQuote() {
    assertThatThrownBy(() -> AgentMain.words("'python"))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("--bridge-command");
  }
}
