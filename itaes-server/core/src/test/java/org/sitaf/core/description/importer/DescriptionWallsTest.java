package org.sitaf.core.description.importer;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.core.importer.ImportOption.DoNotIncludeTests;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.library.dependencies.SlicesRuleDefinition;

/** The importers know nothing of each other, and what they read with stays with them. */
@AnalyzeClasses(packages = "org.sitaf.core.description", importOptions = DoNotIncludeTests.class)
class DescriptionWallsTest {
  @ArchTest
  static final ArchRule PACKAGES_HAVE_NO_CYCLES =
      SlicesRuleDefinition.slices()
          .matching("org.sitaf.core.(description..)")
          .should()
          .beFreeOfCycles();

  @ArchTest
  static final ArchRule IMPORTERS_KNOW_NOTHING_OF_EACH_OTHER =
      SlicesRuleDefinition.slices()
          .matching("org.sitaf.core.description.(opros|idl|ros|proto)..")
          .should()
          .notDependOnEachOther();

  @ArchTest
  static final ArchRule ANTLR_STAYS_WITH_IDL =
      noClasses()
          .that()
          .resideOutsideOfPackage("..idl..")
          .should()
          .dependOnClassesThat()
          .resideInAPackage("org.antlr..");

  @ArchTest
  static final ArchRule WIRE_STAYS_WITH_PROTOBUF =
      noClasses()
          .that()
          .resideOutsideOfPackage("..proto..")
          .should()
          .dependOnClassesThat()
          .resideInAPackage("com.squareup..");
}
