package org.sitaf.agent.toolchain.java;

import com.sun.source.tree.ClassTree;
import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.Tree;
import com.sun.source.util.JavacTask;
import java.io.IOException;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.Callable;
import javax.tools.JavaCompiler;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.toolchain.CompilationException;

/**
 * One run of javac. The sources are parsed first, so that a class that nobody defines is told as
 * such and not as a hundred unknown symbols.
 */
final class JavaCompilation implements Callable<@Nullable Void> {
  static final List<String> OPTIONS =
      List.of("-proc:none", "--release", "17", "-g", "-nowarn", "-implicit:none");

  private final JavacTask task;
  private final DiagnosticCollection errors;
  private final ComponentClass component;

  JavaCompilation(
      JavaCompiler javac,
      AbortableFiles files,
      DiagnosticCollection errors,
      List<JavaSource> sources,
      ComponentClass component) {
    this.task = (JavacTask) javac.getTask(null, files, errors, OPTIONS, null, sources);
    this.errors = errors;
    this.component = component;
  }

  @Override
  public @Nullable Void call() throws IOException, CompilationException {
    Iterable<? extends CompilationUnitTree> units = task.parse();
    if (errors.isEmpty()) {
      component.requireAmong(declaredTypes(units));
      task.analyze();
    }
    if (errors.isEmpty()) {
      task.generate();
    }
    return null;
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
