#pragma once

#include "sitaf/runtime/stub.hpp"

namespace sitaf::harness::getinfrareddata {

/// Test stub (TS): not used, because the component requires no interface.
class TestStub {
 public:
  explicit TestStub(runtime::TestRun& /*run*/) {}

  void prepare() {}
};

}  // namespace sitaf::harness::getinfrareddata
