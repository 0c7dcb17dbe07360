package org.sitaf.agent.toolchain.java.confined;

import com.sun.source.tree.ClassTree;
import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.Tree;
import com.sun.source.util.JavacTask;
import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.StandardLocation;
import javax.tools.ToolProvider;

/**
 * Runs javac with the same runtime several times and reuses what was read of it. Sources are parsed
 * first, so that a missing component class gives one clear error instead of a hundred unknown
 * symbols.
 */
final class JavaCompilation {
  private final JavaCompiler javac = ToolProvider.getSystemJavaCompiler();
  private final StandardJavaFileManager files =
      javac.getStandardFileManager(null, Locale.ROOT, StandardCharsets.UTF_8);
  private final List<File> runtime;
  private final List<File> processors;
  private final List<String> options;

  /**
   * Creates a compilation environment.
   *
   * @param runtime jars at the start of each class path
   * @param processors jars of annotation processors and compiler plugins that the administrator
   *     allows
   */
  JavaCompilation(List<File> runtime, List<File> processors, List<String> options)
      throws IOException {
    this.runtime = runtime;
    this.processors = processors;
    this.options = options;
    files.setLocation(StandardLocation.SOURCE_PATH, List.of());
    files.setLocation(StandardLocation.ANNOTATION_PROCESSOR_PATH, processors);
  }

  /** Compiles and sends the result. */
  void run(CompileRequest request, OutputStream output) throws IOException {
    List<File> classPath = new ArrayList<>(runtime);
    classPath.addAll(request.libraries());
    files.setLocation(StandardLocation.CLASS_PATH, classPath);
    CompilerErrors errors = new CompilerErrors(output);
    JavacTask task =
        (JavacTask)
            javac.getTask(
                null,
                new CompilerFiles(files, !processors.isEmpty(), output),
                errors,
                options,
                null,
                request.sources());
    Iterable<? extends CompilationUnitTree> units = task.parse();
    if (errors.count() == 0) {
      if (!new ComponentClass(request).isAmong(declaredTypes(units), output)) {
        return;
      }
      task.analyze();
    }
    if (errors.count() == 0) {
      task.generate();
    }
    Wire.write(output, Wire.DONE, Integer.toString(errors.count()));
  }

  private static Set<String> declaredTypes(Iterable<? extends CompilationUnitTree> units) {
    Set<String> names = new TreeSet<>();
    for (CompilationUnitTree unit : units) {
      String prefix = unit.getPackageName() == null ? "" : unit.getPackageName() + ".";
      for (Tree type : unit.getTypeDecls()) {
        if (type instanceof ClassTree declared) {
          names.add(prefix + declared.getSimpleName());
        }
      }
    }
    return names;
  }
}
