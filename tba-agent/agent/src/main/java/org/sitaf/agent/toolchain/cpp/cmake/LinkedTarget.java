package org.sitaf.agent.toolchain.cpp.cmake;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sitaf.agent.toolchain.cpp.inputs.InputCheck;
import org.sitaf.agent.toolchain.cpp.inputs.Inputs;

/**
 * A target that CMake has built, as its users see it.
 *
 * @param folder CMake's build folder
 * @param compileFlags include folders, definitions and options for sources that use the target
 * @param linkFlags archives and libraries of this machine, after the objects
 * @param sharedLibraries shared libraries of the project; regular files in the build folder
 * @param standard the C++ standard that users of the target need
 * @param opened files of this machine that CMake and the compilers read, by absolute path
 * @param startMillis start of the build in milliseconds since 1970
 * @param warnings what the compilers printed
 */
public record LinkedTarget(
    Path folder,
    List<String> compileFlags,
    List<String> linkFlags,
    List<Path> sharedLibraries,
    int standard,
    List<String> opened,
    long startMillis,
    String warnings) {
  /** Where CMake searches packages. */
  private static final List<String> PACKAGE_FOLDERS =
      List.of(
          "/usr/bin",
          "/usr/include",
          "/usr/lib",
          "/usr/lib/cmake",
          "/usr/lib/pkgconfig",
          "/usr/share",
          "/usr/share/cmake",
          "/usr/share/pkgconfig",
          "/usr/local/bin",
          "/usr/local/include",
          "/usr/local/lib",
          "/usr/local/lib/cmake",
          "/usr/local/share");

  public LinkedTarget {
    compileFlags = List.copyOf(compileFlags);
    linkFlags = List.copyOf(linkFlags);
    sharedLibraries = List.copyOf(sharedLibraries);
    opened = List.copyOf(opened);
  }

  /**
   * The files that the project was built from, and the folders whose entries change when a package
   * is installed; empty if they are uncertain.
   */
  public Optional<Inputs> inputs() throws IOException {
    List<String> searched = new ArrayList<>(PACKAGE_FOLDERS);
    try (DirectoryStream<Path> ofMachine =
        Files.newDirectoryStream(Path.of("/usr/lib"), "*-linux-*")) {
      for (Path path : ofMachine) {
        searched.addAll(List.of(path.toString(), path + "/cmake", path + "/pkgconfig"));
      }
    }
    return InputCheck.ofLinker(opened, searched, startMillis);
  }
}
