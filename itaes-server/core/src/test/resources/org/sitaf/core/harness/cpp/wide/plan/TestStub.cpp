#include "TestStub.hpp"

#include <stdexcept>
#include <string>

#include "sitaf/interfaces/NoEcho.hpp"

namespace sitaf::harness::plan {
namespace {

/// Throws the exception of an answer.
void raise(const std::string& name) {
  if (name == "NoEcho") {
    throw interfaces::NoEcho();
  }
  throw std::runtime_error(name);
}

}  // namespace

double RangeFinderStub::Range(std::int32_t index, double& quality) {
  const runtime::StubbedCall call(stubbing_, "RangeFinder.Range",
                                  {runtime::argument("index", index)});
  quality = rangeQuality_.give(call);
  return range_.give(call);
}

void RangeFinderStub::Switch(bool on) {
  const runtime::StubbedCall call(stubbing_, "RangeFinder.Switch", {runtime::argument("on", on)});
}

TestStub::TestStub(runtime::TestRun& run) : stubbing_(run, raise), rangeFinder_(stubbing_) {}

void TestStub::prepare(const runtime::Answer<double>& rangeFinderRange,
                       const runtime::Answer<double>& rangeFinderRange2,
                       const runtime::Answer<double>& rangeFinderRangeQuality) {
  stubbing_.begin({"RangeFinder.Range", "RangeFinder.Switch"});
  rangeFinder_.range_.reset();
  rangeFinder_.range_.set(1, rangeFinderRange);
  rangeFinder_.range_.set(2, rangeFinderRange2);
  rangeFinder_.rangeQuality_.reset();
  rangeFinder_.rangeQuality_.set(1, rangeFinderRangeQuality);
}

}  // namespace sitaf::harness::plan
