package org.sitaf.core.description.importer;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.core.importer.ImportOption.DoNotIncludeTests;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.library.dependencies.SlicesRuleDefinition;

/** The importers do not depend on each other and do not expose their parsers. */
@AnalyzeClasses(packages = "org.sitaf.core.description", importOptions = DoNotIncludeTests.class)
class ImporterDependenciesTest {
  @ArchTest
  static final ArchRule PACKAGES_HAVE_NO_CYCLES =
      SlicesRuleDefinition.slices()
          .matching("org.sitaf.core.(description..)")
          .should()
          .beFreeOfCycles();

  @ArchTest
  static final ArchRule IMPORTERS_DO_NOT_DEPEND_ON_EACH_OTHER =
      SlicesRuleDefinition.slices()
          .matching("org.sitaf.core.description.(opros|idl|ros|proto)..")
          .should()
          .notDependOnEachOther();

  @ArchTest
  static final ArchRule ONLY_IDL_USES_ANTLR =
      noClasses()
          .that()
          .resideOutsideOfPackage("..idl..")
          .should()
          .dependOnClassesThat()
          .resideInAPackage("org.antlr..");

  @ArchTest
  static final ArchRule ONLY_PROTOBUF_USES_WIRE =
      noClasses()
          .that()
          .resideOutsideOfPackage("..proto..")
          .should()
          .dependOnClassesThat()
          .resideInAPackage("com.squareup..");
}
