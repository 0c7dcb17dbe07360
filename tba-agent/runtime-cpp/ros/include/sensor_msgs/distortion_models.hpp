#pragma once

namespace sensor_msgs {
namespace distortion_models {

const char PLUMB_BOB[] = "plumb_bob";
const char RATIONAL_POLYNOMIAL[] = "rational_polynomial";
const char EQUIDISTANT[] = "equidistant";

}  // namespace distortion_models
}  // namespace sensor_msgs
