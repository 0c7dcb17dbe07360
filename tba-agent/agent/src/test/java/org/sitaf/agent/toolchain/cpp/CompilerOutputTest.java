package org.sitaf.agent.toolchain.cpp;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class CompilerOutputTest {
  @Test
  void keepsWarningsAboutTheUsersSourcesOnly() {
    CompilerOutput output =
        new CompilerOutput(
            path ->
                path.startsWith("activity/")
                    ? new CompilerOutput.Place(path, false)
                    : CompilerOutput.Place.ELSEWHERE);
    output.readWarnings(
        """
        activity/component/spin.cpp: In member function 'int Spin::Run()':
        activity/component/spin.cpp:12:1: warning: no return statement in function returning non-void [-Wreturn-type]
        activity/component/spin.cpp:12:1: warning: no return statement in function returning non-void [-Wreturn-type]
        /usr/include/kdl/frames.hpp:90:5: warning: unused variable 'x' [-Wunused-variable]
        """);
    assertThat(output.warnings())
        .containsExactly(
            "activity/component/spin.cpp:12:1: warning: no return statement in function returning"
                + " non-void [-Wreturn-type]");
    assertThat(output.errors()).isEmpty();
  }
}
