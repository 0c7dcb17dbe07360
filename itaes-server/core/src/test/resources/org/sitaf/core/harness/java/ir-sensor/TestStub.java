package sitaf.harness.getinfrareddata;

/** Test stub (TS): not used, because the component requires no interface. */
final class TestStub {
  void prepare() {}
}
