package sitaf.harness.getinfrareddata;

/** Test stub (TS): the component requires no interface, so that there is nothing to answer. */
final class TestStub {
  void prepare() {}
}
