#pragma once

#include <cstdint>

#include "sitaf/interfaces/RangeFinder.hpp"
#include "sitaf/runtime/stub.hpp"

namespace sitaf::harness::plan {

/// Stub of the required interface RangeFinder.
class RangeFinderStub final : public interfaces::RangeFinder {
 public:
  explicit RangeFinderStub(runtime::Stubbing& stubbing) : stubbing_(stubbing) {}

  double Range(std::int32_t index, double& quality) override;
  void Switch(bool on) override;

 private:
  friend class TestStub;

  runtime::Stubbing& stubbing_;
  runtime::Answers<double> range_;
  runtime::Answers<double> rangeQuality_;
};

/// Test stub (TS): implements the interfaces that the component requires. Records all calls as part
/// of the result.
class TestStub {
 public:
  explicit TestStub(runtime::TestRun& run);

  /// Sets the answers of a case.
  void prepare(const runtime::Answer<double>& rangeFinderRange,
               const runtime::Answer<double>& rangeFinderRange2,
               const runtime::Answer<double>& rangeFinderRangeQuality);

  interfaces::RangeFinder& rangeFinder() { return rangeFinder_; }

 private:
  runtime::Stubbing stubbing_;
  RangeFinderStub rangeFinder_;
};

}  // namespace sitaf::harness::plan
