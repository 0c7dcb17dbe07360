#pragma once

#include <cstdint>

#include "sitaf/interfaces/RangeFinder.hpp"
#include "sitaf/runtime/stub.hpp"

namespace sitaf::harness::plan {

/// The required interface RangeFinder, as a case answers for it.
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

/// Test stub (TS): answers for the interfaces that the component requires. What it is asked becomes
/// part of the result.
class TestStub {
 public:
  explicit TestStub(runtime::TestRun& run);

  /// Sets what each method answers in a case.
  void prepare(const runtime::Answer<double>& rangeFinderRange,
               const runtime::Answer<double>& rangeFinderRange2,
               const runtime::Answer<double>& rangeFinderRangeQuality);

  interfaces::RangeFinder& rangeFinder() { return rangeFinder_; }

 private:
  runtime::Stubbing stubbing_;
  RangeFinderStub rangeFinder_;
};

}  // namespace sitaf::harness::plan
