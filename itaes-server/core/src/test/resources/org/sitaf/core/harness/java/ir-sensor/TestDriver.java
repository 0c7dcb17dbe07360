package sitaf.harness.getinfrareddata;

import org.sitaf.examples.ir.InfraredSensor;
import org.sitaf.runtime.LifeCycle;
import org.sitaf.runtime.Stopwatch;
import org.sitaf.runtime.SuiteDriver;
import org.sitaf.runtime.TestRun;
import org.sitaf.runtime.suite.CaseResult;
import org.sitaf.runtime.suite.TestCase;

/**
 * Test driver (TD) of InfraredSensorService.GetInfraredData: runs the cases of the test model
 * GetInfraredData.
 *
 * <p>Distance to the obstacle, as infrared sensor IndexOfSensor sees it
 */
abstract class TestDriver extends SuiteDriver<InfraredSensor> {
  private final SimulationControl simulationControl;
  private final TestStub testStub;

  TestDriver(TestRun run) {
    super(run, LifeCycle.CASE);
    simulationControl = new SimulationControl(run.simulation());
    testStub = new TestStub();
  }

  /**
   * Calls the method under test, InfraredSensorService.GetInfraredData. Only this call is timed.
   */
  abstract double call(InfraredSensor component, int indexOfSensor, int numOfSensor)
      throws Exception;

  /** Creates the component. Passes the hardware and stubs that its constructor requires. */
  final InfraredSensor newComponent() throws Exception {
    return newComponent(InfraredSensor.class);
  }

  @Override
  protected final void runCase(TestCase testCase, CaseResult result) throws Exception {
    // 1. Read the test case.
    int indexOfSensor = testCase.intValue("IndexOfSensor");
    int numOfSensor = testCase.intValue("NumOfSensor");
    double distance = testCase.doubleValue("Distance");

    // 2. The simulation control sets up the virtual environment (TDSD).
    simulationControl.prepare(distance);

    // 3. The test stub gets the answers of the required interfaces (TDTS).
    testStub.prepare();

    // 4. The component is called with the input (TDI). The call is timed.
    InfraredSensor component = component();
    beforeCase(component, testCase);
    Stopwatch stopwatch = stopwatch();
    stopwatch.start();
    double returned = call(component, indexOfSensor, numOfSensor);
    stopwatch.stop();
    afterCase(component, testCase);

    // 5. The outputs are recorded and saved.
    result.record("return", returned);
    save(result);
  }
}
