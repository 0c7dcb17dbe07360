package org.sitaf.server;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import jakarta.persistence.Entity;

/** The walls between the rooms of the server. */
@AnalyzeClasses(packages = "org.sitaf.server", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
  @ArchTest
  static final ArchRule CAPABILITIES_DO_NOT_DEPEND_ON_EACH_OTHER_IN_CIRCLES =
      slices().matching("org.sitaf.server.(*)..").should().beFreeOfCycles();

  @ArchTest
  static final ArchRule PACKAGES_DO_NOT_DEPEND_ON_EACH_OTHER_IN_CIRCLES =
      slices().matching("org.sitaf.server.(**)").should().beFreeOfCycles();

  @ArchTest
  static final ArchRule THE_DOMAIN_DOES_NOT_KNOW_THE_WEB =
      noClasses()
          .that()
          .areAnnotatedWith(Entity.class)
          .or()
          .haveSimpleNameEndingWith("Repository")
          .or()
          .resideInAPackage("org.sitaf.server.build")
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage(
              "org.springframework.web..",
              "jakarta.servlet..",
              "io.grpc..",
              "org.sitaf.agent.v1..",
              "org.sitaf.server.web..");

  @ArchTest
  static final ArchRule ONLY_THE_AGENTS_ROOM_SPEAKS_THEIR_PROTOCOL =
      noClasses()
          .that()
          .resideOutsideOfPackage("org.sitaf.server.build.agent..")
          .should()
          .dependOnClassesThat()
          .resideInAPackage("org.sitaf.agent.v1..");

  @ArchTest
  static final ArchRule CONTROLLERS_ARE_NOBODY_ELSES_BUSINESS =
      classes().that().haveSimpleNameEndingWith("Controller").should().bePackagePrivate();
}
