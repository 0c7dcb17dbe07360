package robot;

import org.sitaf.runtime.Hardware;
import org.sitaf.runtime.Out;
import sitaf.interfaces.Busy;
import sitaf.interfaces.Mode;
import sitaf.interfaces.Path;
import sitaf.interfaces.Planner;
import sitaf.interfaces.Point;
import sitaf.interfaces.RangeFinder;

/** Binds the component to the interfaces of its test. */
public final class PlannerAdapter implements Planner {
  public PlannerAdapter(Hardware hardware, RangeFinder rangeFinder) {
    // Create the component here and store it in a field.
    // The hardware gives access to the simulated devices.
    // The required interfaces are implemented by the test stub.
  }

  @Override
  public Path Plan(Point goal, double[] weights, Out<Boolean> found, Out<Integer> budget) {
    // Delegate the call to the component and return its result.
    // Set out-parameters by set().
    throw new UnsupportedOperationException("Plan is not implemented yet");
  }

  @Override
  public void SetMode(Mode mode) throws Busy {
    // Delegate the call to the component.
    throw new UnsupportedOperationException("SetMode is not implemented yet");
  }

  @Override
  public void SetLimit(int limit) {
    // Delegate the call to the component.
    throw new UnsupportedOperationException("SetLimit is not implemented yet");
  }
}
