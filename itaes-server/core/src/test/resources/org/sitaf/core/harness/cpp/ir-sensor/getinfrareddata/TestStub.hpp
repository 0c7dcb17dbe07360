#pragma once

#include "sitaf/runtime/stub.hpp"

namespace sitaf::harness::getinfrareddata {

/// Test stub (TS): the component requires no interface, so that there is nothing to answer.
class TestStub {
 public:
  explicit TestStub(runtime::TestRun& /*run*/) {}

  void prepare() {}
};

}  // namespace sitaf::harness::getinfrareddata
