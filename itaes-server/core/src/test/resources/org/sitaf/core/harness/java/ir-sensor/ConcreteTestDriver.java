package sitaf.harness.getinfrareddata;

import org.sitaf.examples.ir.InfraredSensor;
import org.sitaf.runtime.TestRun;
import org.sitaf.runtime.suite.TestCase;

/**
 * Concrete test driver of InfraredSensorService.GetInfraredData. You may edit this class.
 *
 * <p>To keep your changes, save this file in the activity as
 * harness/GetInfraredData/ConcreteTestDriver.java. It then replaces the generated file.
 */
public final class ConcreteTestDriver extends TestDriver {
  private ConcreteTestDriver(TestRun run) {
    super(run);
  }

  public static void main(String[] args) {
    TestRun.start(args, ConcreteTestDriver::new);
  }

  /** Creates and sets up the component. */
  @Override
  protected InfraredSensor createComponent() throws Exception {
    InfraredSensor component = newComponent();
    setProperty(component, "Size", "7");
    begin(component);
    component.Enable();
    return component;
  }

  /** Runs before each call, after the world and the stub are prepared. */
  @Override
  protected void beforeCase(InfraredSensor component, TestCase testCase) throws Exception {}

  /** Runs after each call, before its result is compared. */
  @Override
  protected void afterCase(InfraredSensor component, TestCase testCase) throws Exception {}

  /** Calls the method under test. Only this call is timed. */
  @Override
  double call(InfraredSensor component, int indexOfSensor, int numOfSensor) throws Exception {
    return component.GetInfraredData(indexOfSensor, numOfSensor);
  }
}
