package org.sitaf.agent.toolchain.cpp;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class CppLibrariesTest {
  private static String printed(String soname) {
    return "  Tag        Type         Name/Value\n"
        + " 0x000000000000000e (SONAME)             Library soname: ["
        + soname
        + "]\n";
  }

  @Test
  void readsTheSonameOfALibrary() {
    assertThat(CppLibraries.soname(printed("libarm.so.1"))).contains("libarm.so.1");
    assertThat(CppLibraries.soname(printed("libstdc++.so.6"))).contains("libstdc++.so.6");
    assertThat(CppLibraries.soname("")).isEmpty();
  }

  /** The library is copied under this name, and may come from anybody. */
  @ParameterizedTest
  @ValueSource(strings = {"..", ".", "../x", "/etc/passwd", "a\u0000b", "a\nb", "-rf", " "})
  void ignoresASonameThatIsNoFileName(String soname) {
    assertThat(CppLibraries.soname(printed(soname))).isEmpty();
  }

  private static boolean areInputsListed(String flag) {
    return new CppLibraries(List.of("-I", "/usr/include/eigen3", flag), List.of(), null)
        .areInputsListed();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "-DNAME=@x",
        "-mavx",
        "-fopenmp",
        "-include",
        "-isystem",
        "-std=gnu++20",
        "-pthread"
      })
  void theCompilerListsWhatOrdinaryOptionsRead(String flag) {
    assertThat(areInputsListed(flag)).isTrue();
  }

  /** An object that depends on other files would be stale when they change. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "@/p/options",
        "-B/p/bin",
        "-specs=/p/own.specs",
        "--specs=/p/own.specs",
        "-wrapper",
        "-fplugin=/p/x.so",
        "-fprofile-use=/p/x.gcda",
        "-Wa,--defsym,X=1",
        "-Xclang",
        "--sysroot=/p"
      })
  void theCompilerDoesNotListWhatOtherOptionsRead(String flag) {
    assertThat(areInputsListed(flag)).isFalse();
  }
}
