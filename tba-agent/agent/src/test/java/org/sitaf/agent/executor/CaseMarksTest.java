package org.sitaf.agent.executor;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class CaseMarksTest {
  private final List<String> output = new ArrayList<>();
  private final CaseMarks marks = new CaseMarks((text, no) -> output.add(no + "|" + text));

  @Test
  void attributesTextToTheCaseThatPrintedIt() {
    marks.read("before\n\u001ecase 7\nseven\nmore\u001ecase 12\ntwelve\n\u001ecase 0\nafter");
    assertThat(output).containsExactly("0|before\n", "7|seven\nmore", "12|twelve\n", "0|after");
  }

  @Test
  void readsAMarkInPieces() {
    for (char c : "a\u001ecase 7\nb".toCharArray()) {
      marks.read(String.valueOf(c));
    }
    assertThat(output).containsExactly("0|a", "7|b");
  }

  @Test
  void treatsInvalidMarksAsText() {
    marks.read("\u001ecase x\ny \u001e\u001ecase 3\nthree \u001ecase 12345678901\n");
    assertThat(String.join("", output.stream().map(text -> text.substring(2)).toList()))
        .isEqualTo("\u001ecase x\ny \u001ethree \u001ecase 12345678901\n");
    assertThat(output).contains("3|three ");
  }
}
