package sitaf.harness.getinfrareddata;

import org.sitaf.examples.ir.InfraredSensor;
import org.sitaf.runtime.TestRun;
import org.sitaf.runtime.suite.TestCase;

/**
 * Concrete test driver: what is particular about testing InfraredSensorService.GetInfraredData, to
 * be changed freely.
 *
 * <p>Keep a changed version in the activity as harness/GetInfraredData/ConcreteTestDriver.java: it
 * is used from then on, and never generated over.
 */
public final class ConcreteTestDriver extends TestDriver {
  private ConcreteTestDriver(TestRun run) {
    super(run);
  }

  public static void main(String[] args) {
    TestRun.start(args, ConcreteTestDriver::new);
  }

  /** Makes the component and sets it up. */
  @Override
  protected InfraredSensor createComponent() throws Exception {
    InfraredSensor component = newComponent();
    setProperty(component, "Size", "7");
    begin(component);
    component.Enable();
    return component;
  }

  /** Runs before each call, when the world and the stub are set. */
  @Override
  protected void beforeCase(InfraredSensor component, TestCase testCase) throws Exception {}

  /** Runs after each call, before its result is judged. */
  @Override
  protected void afterCase(InfraredSensor component, TestCase testCase) throws Exception {}

  /** The call under test; nothing else is timed. */
  @Override
  double call(InfraredSensor component, int indexOfSensor, int numOfSensor) throws Exception {
    return component.GetInfraredData(indexOfSensor, numOfSensor);
  }
}
