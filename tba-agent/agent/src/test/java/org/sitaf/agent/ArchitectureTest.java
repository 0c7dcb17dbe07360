package org.sitaf.agent;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;

/** The dependency rules between the agent's packages. */
@AnalyzeClasses(
    packages = "org.sitaf.agent",
    importOptions = {ImportOption.DoNotIncludeTests.class, ArchitectureTest.OwnClasses.class})
class ArchitectureTest {
  /** The generated protocol classes are in a subpackage of the agent's package. */
  static final class OwnClasses implements ImportOption {
    @Override
    public boolean includes(com.tngtech.archunit.core.importer.Location location) {
      return !location.contains("org/sitaf/agent/v1/");
    }
  }

  @ArchTest
  static final ArchRule compilerAndExecutorKnowNoServer =
      noClasses()
          .that()
          .resideInAnyPackage(
              "..agent.compiler..",
              "..agent.executor..",
              "..agent.build..",
              "..agent.sandbox..",
              "..agent.simulation..",
              "..agent.spool..",
              "..agent.toolchain..")
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage("..agent.manager..");

  @ArchTest
  static final ArchRule onlyTheManagerKnowsTheServersWire =
      noClasses()
          .that()
          .resideOutsideOfPackage("..agent.manager..")
          .should()
          .dependOnClassesThat()
          .resideInAPackage("org.sitaf.agent.v1..");

  @ArchTest
  static final ArchRule onlySimulationKnowsTheSimulatorsWire =
      noClasses()
          .that()
          .resideOutsideOfPackage("..agent.simulation..")
          .should()
          .dependOnClassesThat()
          .resideInAPackage("org.sitaf.sim.v1..");

  @ArchTest
  static final ArchRule theRuntimeOfTestApplicationsIsNotTheAgents =
      noClasses().should().dependOnClassesThat().resideInAPackage("org.sitaf.runtime..");

  @ArchTest
  static final ArchRule packagesHaveNoCycles =
      slices().matching("org.sitaf.agent.(*)..").should().beFreeOfCycles();
}
