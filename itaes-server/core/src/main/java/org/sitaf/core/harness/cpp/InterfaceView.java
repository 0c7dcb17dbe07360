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
    String name, List<String> includes, String documentation, List<String> methods) {

  static InterfaceView of(String name, String source, List<Method> methods, boolean required) {
    List<DataType> types = new ArrayList<>();
    for (Method method : methods) {
      types.add(method.returnType());
      method.parameters().forEach(p -> types.add(p.type()));
    }
    return new InterfaceView(
        name,
        new Includes().types(types).lines(),
        CppText.documentation(
            0,
            List.of(
                "The "
                    + (required ? "required" : "provided")
                    + " interface "
                    + CppText.comment(name)
                    + ", described in "
                    + CppText.comment(source)
                    + ".")),
        methods.stream().map(InterfaceView::declaration).toList());
  }

  private static String declaration(Method method) {
    CppNames scope = new CppNames();
    return CppText.list(
        2,
        "virtual " + CppType.within(method.returnType()) + " " + method.name() + "(",
        method.parameters().stream()
            .map(p -> CppType.parameter(p, scope.local(p.name()), true))
            .toList(),
        ") = 0;");
  }
}
