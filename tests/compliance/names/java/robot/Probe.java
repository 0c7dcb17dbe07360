package robot;

import sitaf.interfaces.Duration_;
import sitaf.interfaces.TestStub_;

/** Uses names of its interface that Java does not allow. */
public final class Probe {
  public Duration_ Trace(Duration_ given, Duration_ whole) {
    TestStub_ delete = whole.delete() == TestStub_.new_ ? TestStub_.new_ : whole.delete();
    return new Duration_(2 * given.from(), whole.class_(), delete, whole.pass());
  }
}
