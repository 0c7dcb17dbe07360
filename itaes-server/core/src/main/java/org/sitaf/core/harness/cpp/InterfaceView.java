package org.sitaf.core.harness.cpp;

import java.util.ArrayList;
import java.util.List;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Method;
import org.sitaf.core.harness.cpp.syntax.CppNames;
import org.sitaf.core.harness.cpp.syntax.CppText;
import org.sitaf.core.harness.cpp.syntax.CppType;

/** The view of an interface. */
record InterfaceView(
    String name,
    List<String> includes,
    boolean required,
    String described,
    String source,
    List<String> methods) {

  static InterfaceView of(String name, String source, List<Method> methods, boolean required) {
    List<DataType> types = new ArrayList<>();
    for (Method method : methods) {
      types.add(method.returnType());
      method.parameters().forEach(p -> types.add(p.type()));
    }
    return new InterfaceView(
        name,
        new Includes().types(types).lines(),
        required,
        CppText.comment(name),
        CppText.comment(source),
        methods.stream().map(InterfaceView::declaration).toList());
  }

  private static String declaration(Method method) {
    CppNames scope = new CppNames();
    return CppText.list(
        "virtual " + CppType.within(method.returnType()) + " " + method.name() + "(",
        method.parameters().stream()
            .map(p -> CppType.parameter(p, scope.local(p.name()), true))
            .toList(),
        ") = 0;");
  }
}
