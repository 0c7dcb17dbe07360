package org.sitaf.core.model.document;

import java.io.InputStream;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.document.ElementLines;
import org.sitaf.core.document.XmlDocuments;
import org.sitaf.core.model.TestModel;
import org.sitaf.schemas.TestModelDocument;

/** Reads test model documents (schemas/test_model.xsd). */
public final class TestModelXml {
  private TestModelXml() {}

  /**
   * Reads a test model and checks that it is consistent.
   *
   * @param file name of the document, for diagnostics
   * @throws org.sitaf.core.diagnostic.InvalidInputException with all problems of the document
   */
  public static TestModel read(InputStream document, String file) {
    Diagnostics diagnostics = new Diagnostics();
    ElementLines lines =
        new ElementLines(ConditionReader.PRE_CONDITION, ConditionReader.POST_CONDITION);
    TestModelDocument root =
        XmlDocuments.read(
            document, file, "test_model", TestModelDocument.class, diagnostics, lines);
    TestModel model = new TestModelReader(file, diagnostics, lines).read(root);
    // Warnings are errors here: an unknown element of a test model is most likely a typo.
    Diagnostics strict = new Diagnostics();
    diagnostics.all().forEach(d -> strict.error(d.file(), d.line(), d.element(), d.message()));
    strict.throwIfErrors();
    return model;
  }
}
