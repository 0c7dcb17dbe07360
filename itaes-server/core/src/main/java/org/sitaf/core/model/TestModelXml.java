package org.sitaf.core.model;

import java.io.InputStream;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.document.ElementLines;
import org.sitaf.core.document.XmlDocuments;
import org.sitaf.schemas.TestModelDocument;

/** The document of a test model (schemas/test_model.xsd). */
public final class TestModelXml {
  private TestModelXml() {}

  /**
   * Reads a test model and verifies that it does not contradict itself.
   *
   * @param file name of the document, for diagnostics
   * @throws org.sitaf.core.diagnostic.InvalidInputException with every problem of the document
   */
  public static TestModel read(InputStream document, String file) {
    Diagnostics diagnostics = new Diagnostics();
    ElementLines lines =
        new ElementLines(TestModelReader.PRE_CONDITION, TestModelReader.POST_CONDITION);
    TestModelDocument root =
        XmlDocuments.read(
            document, file, "test_model", TestModelDocument.class, diagnostics, lines);
    TestModel model = new TestModelReader(file, diagnostics, lines).read(root);
    // A model has few elements and each has a meaning: one that is passed over is a mistake.
    Diagnostics strict = new Diagnostics();
    diagnostics.all().forEach(d -> strict.error(d.file(), d.line(), d.element(), d.message()));
    strict.throwIfErrors();
    return model;
  }
}
