package org.sitaf.agent.toolchain.cpp.inputs;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sitaf.agent.toolchain.cpp.inputs.AskedNames.Name;

/** Finds all names that a compiler may search. */
class AskedNamesTest {
  private static AskedNames in(String text) {
    return AskedNames.in(text.getBytes(UTF_8));
  }

  @Test
  void findsNamesInAllBranches() {
    AskedNames asked =
        in(
            """
            #include "a.hpp"
              #  include <b/c.hpp>
            #if 0
            #inc\\
            lude_next "d.hpp"
            #endif
            %:import "ä.hpp"
            /* */ # /* */ include "f.hpp"
            #if defined(__has_include) && __has_include("e.hpp")
            """);

    assertThat(asked.names())
        .containsExactly(
            new Name("a.hpp", true),
            new Name("b/c.hpp", false),
            new Name("d.hpp", true),
            new Name("ä.hpp", true),
            new Name("f.hpp", true),
            new Name("e.hpp", true));
    assertThat(asked.computed()).isFalse();
    assertThat(asked.unknown()).isFalse();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"#include NAME", "#include/**/\"a.hpp\"", "#include \"/usr/include/a.hpp\""})
  void aNameThatNoTextShowsIsSeenAsSuch(String text) {
    assertThat(in(text).computed()).isTrue();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "#if __has_include(NAME)",
        "#define there(x) __has_include(x)",
        "#define there __has_include",
        "#if __has_include(\"/etc/passwd\")"
      })
  void aQuestionThatNoTextShowsMakesTheSourceUncertain(String text) {
    assertThat(in(text).unknown()).isTrue();
  }

  @Test
  void ignoresNamesInComments() {
    AskedNames asked = in("// we include what we import\n#ifdef __has_include\n#endif\n");

    assertThat(asked.names()).isEmpty();
    assertThat(asked.computed()).isFalse();
    assertThat(asked.unknown()).isFalse();
  }
}
