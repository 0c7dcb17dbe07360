package org.sitaf.core;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;

import com.tngtech.archunit.core.importer.ImportOption.DoNotIncludeTests;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;

/** The walls of the core, as ARCHITECTURE.md draws them. */
@AnalyzeClasses(packages = "org.sitaf.core", importOptions = DoNotIncludeTests.class)
class WallsTest {
  @ArchTest
  static final ArchRule roomsDoNotDependOnEachOtherInCircles =
      slices().matching("org.sitaf.core.(*)..").should().beFreeOfCycles();

  @ArchTest
  static final ArchRule theCoreIsUsableWithoutAServer =
      noClasses()
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage("org.springframework..", "jakarta.persistence..", "io.grpc..");

  @ArchTest
  static final ArchRule suitesAndResultsDoNotKnowHowTheyAreWritten =
      noClasses()
          .that()
          .resideInAnyPackage("org.sitaf.core.suite", "org.sitaf.core.verdict")
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage("..suite.document..", "..verdict.document..");

  @ArchTest
  static final ArchRule filesAreForTheRim =
      noClasses()
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage("java.nio.file..", "java.net..")
          .orShould()
          .dependOnClassesThat()
          .haveFullyQualifiedName("java.io.File");

  @ArchTest
  static final ArchRule nothingAsksForTheTime =
      noClasses()
          .should()
          .callMethod(System.class, "currentTimeMillis")
          .orShould()
          .callMethod(System.class, "nanoTime")
          .orShould()
          .callMethod(java.time.Instant.class, "now")
          .orShould()
          .dependOnClassesThat()
          .haveFullyQualifiedName("java.time.Clock");

  @ArchTest
  static final ArchRule thereIsNoStaticState =
      fields()
          .that()
          .areStatic()
          .and()
          .areDeclaredInClassesThat()
          .areNotAssignableTo("org.antlr.v4.runtime.Recognizer") // as its generator writes it
          .should()
          .beFinal();

  @ArchTest
  static final ArchRule theCombinatorKnowsOnlyNumbers =
      noClasses()
          .that()
          .resideInAPackage("..core.combine..")
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage(
              "..core.model..",
              "..core.suite..",
              "..core.value..",
              "..core.expression..",
              "dev.cel..");
}
