// Frames with transforms over time.
#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "geometry_msgs/msg/transform_stamped.hpp"
#include "tf2/linear_math.hpp"

namespace tf2 {

using Duration = std::chrono::nanoseconds;
using TimePoint = std::chrono::time_point<std::chrono::system_clock, Duration>;
using IDuration = std::chrono::duration<int, std::nano>;
constexpr TimePoint TimePointZero = TimePoint(std::chrono::nanoseconds(0));
inline TimePoint get_now() {return std::chrono::system_clock::now();}
inline Duration durationFromSec(double seconds) {return Duration(static_cast<std::int64_t>(seconds * 1e9));}
inline TimePoint timeFromSec(double seconds) {return TimePoint(durationFromSec(seconds));}
inline double durationToSec(const Duration & time) {return static_cast<double>(time.count()) / 1e9;}
inline double timeToSec(const TimePoint & time) {return durationToSec(time.time_since_epoch());}
std::string displayTimePoint(const TimePoint & time);

enum class TF2Error : std::uint8_t
{
  TF2_NO_ERROR = 0, TF2_LOOKUP_ERROR, TF2_CONNECTIVITY_ERROR, TF2_EXTRAPOLATION_ERROR, TF2_INVALID_ARGUMENT_ERROR,
  TF2_TIMEOUT_ERROR, TF2_TRANSFORM_ERROR, TF2_BACKWARD_EXTRAPOLATION_ERROR, TF2_FORWARD_EXTRAPOLATION_ERROR,
  TF2_NO_DATA_FOR_EXTRAPOLATION_ERROR
};

class TransformException : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};
#define SITAF_TF2_ERROR(name, base) \
  class name : public base \
  { \
  public: \
    explicit name(const std::string & text) \
    : base(text) {} \
  }
SITAF_TF2_ERROR(ConnectivityException, TransformException);
SITAF_TF2_ERROR(LookupException, TransformException);
SITAF_TF2_ERROR(ExtrapolationException, TransformException);
SITAF_TF2_ERROR(BackwardExtrapolationException, ExtrapolationException);
SITAF_TF2_ERROR(ForwardExtrapolationException, ExtrapolationException);
SITAF_TF2_ERROR(NoDataForExtrapolationException, ExtrapolationException);
SITAF_TF2_ERROR(InvalidArgumentException, TransformException);
SITAF_TF2_ERROR(TimeoutException, TransformException);
#undef SITAF_TF2_ERROR

static constexpr Duration BUFFER_CORE_DEFAULT_CACHE_TIME = std::chrono::seconds(10);

class BufferCore
{
public:
  explicit BufferCore(Duration cache = BUFFER_CORE_DEFAULT_CACHE_TIME)
  : cache_(cache.count()) {}
  virtual ~BufferCore() = default;

  void clear() {frames_.clear();}
  bool setTransform(
    const geometry_msgs::msg::TransformStamped & transform, const std::string & authority, bool is_static = false);
  geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target, const std::string & source, const TimePoint & time) const;
  geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target, const TimePoint & target_time, const std::string & source,
    const TimePoint & source_time, const std::string & fixed) const;
  bool canTransform(
    const std::string & target, const std::string & source, const TimePoint & time, std::string * why = nullptr) const;
  bool canTransform(
    const std::string & target, const TimePoint & target_time, const std::string & source,
    const TimePoint & source_time, const std::string & fixed, std::string * why = nullptr) const;
  std::vector<std::string> getAllFrameNames() const;
  std::string allFramesAsYAML() const;
  std::string allFramesAsString() const {return allFramesAsYAML();}
  bool _frameExists(const std::string & frame) const {return frames_.count(frame) > 0;}
  bool _getParent(const std::string & frame, TimePoint, std::string & up) const
  {
    up = _frameExists(frame) ? parent(frame) : "";
    return !up.empty();
  }
  std::vector<std::string> _getFrameStrings() const {return getAllFrameNames();}

protected:
  /// Called after a new transform.
  virtual void changed() {}

private:
  struct Entry
  {
    std::string parent;
    Vector3 origin;
    Quaternion rotation;
  };
  struct Frame
  {
    std::optional<Entry> fixed;
    std::map<std::int64_t, Entry> data;
  };
  using Path = std::vector<std::string>;
  Path path(const std::string & frame) const;
  std::string parent(const std::string & frame) const;
  Transform to_ancestor(const Path & path, std::size_t length, std::int64_t time) const;
  Transform at(const std::string & frame, std::int64_t time) const;
  void require(const std::string & frame) const;

  std::int64_t cache_;
  std::map<std::string, Frame> frames_;
};

}  // namespace tf2
