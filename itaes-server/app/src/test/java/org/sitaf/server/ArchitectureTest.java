package org.sitaf.server;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import jakarta.persistence.Entity;

/** Dependencies between the packages of the server. */
@AnalyzeClasses(packages = "org.sitaf.server", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
  @ArchTest
  static final ArchRule TOP_LEVEL_PACKAGES_ARE_FREE_OF_CYCLES =
      slices().matching("org.sitaf.server.(*)..").should().beFreeOfCycles();

  @ArchTest
  static final ArchRule PACKAGES_ARE_FREE_OF_CYCLES =
      slices().matching("org.sitaf.server.(**)").should().beFreeOfCycles();

  @ArchTest
  static final ArchRule DOMAIN_DOES_NOT_DEPEND_ON_WEB =
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
  static final ArchRule ONLY_BUILD_AGENT_USES_THE_AGENT_PROTOCOL =
      noClasses()
          .that()
          .resideOutsideOfPackage("org.sitaf.server.build.agent..")
          .should()
          .dependOnClassesThat()
          .resideInAPackage("org.sitaf.agent.v1..");

  @ArchTest
  static final ArchRule CONTROLLERS_ARE_PACKAGE_PRIVATE =
      classes().that().haveSimpleNameEndingWith("Controller").should().bePackagePrivate();
}
