#include "probe.hpp"

#include "sitaf/interfaces/TestStub_.hpp"

using sitaf::interfaces::Duration;
using sitaf::interfaces::TestStub_;

Duration robot::Probe::Trace(const Duration& given, const Duration& whole) {
  Duration traced;
  traced.from = 2 * given.from;
  traced.class_ = whole.class_;
  traced.delete_ = whole.delete_ == TestStub_::new_ ? TestStub_::new_ : whole.delete_;
  traced.pass = whole.pass;
  return traced;
}
