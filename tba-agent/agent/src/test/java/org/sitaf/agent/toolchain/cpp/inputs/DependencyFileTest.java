package org.sitaf.agent.toolchain.cpp.inputs;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Dependency files may contain names chosen by users. */
class DependencyFileTest {
  @Test
  void unescapesNames() {
    assertThat(
            DependencyFile.rule(
                "unit", "unit: /a/m.cpp /a/b\\ c/$$x\\#y/h:1.h \\\n /usr/include/features.h\n"))
        .hasValueSatisfying(
            names ->
                assertThat(names)
                    .containsExactly("/a/m.cpp", "/a/b c/$x#y/h:1.h", "/usr/include/features.h"));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "unit: /a/m.cpp",
        "other: /a/m.cpp\n",
        "unit: /a/m.cpp\nunit: /a/b.h\n",
        "unit: /a/\\m.cpp\n",
        "unit: /a/$(x).cpp\n",
        "unit: /a/m.cpp \\",
        "unit: /a/\tm.cpp\n",
        "unit: /a/m\u0000.cpp\n"
      })
  void whatNoToolWritesIsNotUnderstood(String text) {
    assertThat(DependencyFile.rule("unit", text)).isEmpty();
  }

  @Test
  void readsTheDependencyFileOfALinker() {
    assertThat(
            DependencyFile.ofLinker("program: \\\n  /usr/lib/crt1.o \\\n  /a/my lib/x.a\n\nx:\n"))
        .hasValueSatisfying(
            names -> assertThat(names).containsExactly("/usr/lib/crt1.o", "/a/my lib/x.a"));
    assertThat(DependencyFile.ofLinker("program: \\\n  /usr/lib/crt1.o \\\n")).isEmpty();
    assertThat(DependencyFile.ofLinker("program: /usr/lib/crt1.o\n")).isEmpty();
  }
}
