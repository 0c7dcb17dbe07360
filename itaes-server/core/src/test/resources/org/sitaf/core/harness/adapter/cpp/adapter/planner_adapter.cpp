#include "planner_adapter.hpp"

#include <stdexcept>

namespace robot {

PlannerAdapter::PlannerAdapter(sitaf::Hardware& hardware,
                               sitaf::interfaces::RangeFinder& rangeFinder)
    : hardware_(hardware), rangeFinder_(rangeFinder) {
  // Make the component here.
}

sitaf::interfaces::Path PlannerAdapter::Plan(const sitaf::interfaces::Point& goal,
                                             const std::vector<double>& weights, bool& found,
                                             std::int32_t& budget) {
  // Pass the call on to the component, and return what it answers.
  throw std::logic_error("Plan is not passed on yet");
}

void PlannerAdapter::SetMode(sitaf::interfaces::Mode mode) {
  // Pass the call on to the component.
  // It may throw, of sitaf::interfaces: Busy.
  throw std::logic_error("SetMode is not passed on yet");
}

void PlannerAdapter::SetLimit(std::int32_t limit) {
  // Pass the call on to the component.
  throw std::logic_error("SetLimit is not passed on yet");
}

}  // namespace robot
