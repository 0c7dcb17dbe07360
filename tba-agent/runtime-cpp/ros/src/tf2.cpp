#include "tf2/buffer_core.hpp"

#include <algorithm>
#include <cstdio>

namespace tf2 {

namespace {

constexpr std::size_t MOST_DEPTH = 1000;

std::string plain(const std::string & name) {return !name.empty() && name[0] == '/' ? name.substr(1) : name;}

bool finite(const geometry_msgs::msg::Transform & t)
{
  for (const double v : {t.translation.x, t.translation.y, t.translation.z, t.rotation.x, t.rotation.y, t.rotation.z,
      t.rotation.w})
  {
    if (!std::isfinite(v)) {
      return false;
    }
  }
  return true;
}

std::string seconds(std::int64_t nanos)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.6f", static_cast<double>(nanos) / 1e9);
  return text;
}

}  // namespace

std::string displayTimePoint(const TimePoint & time) {return seconds(time.time_since_epoch().count());}

bool BufferCore::setTransform(
  const geometry_msgs::msg::TransformStamped & transform, const std::string &, bool is_static)
{
  const std::string child = plain(transform.child_frame_id), parent = plain(transform.header.frame_id);
  const auto & t = transform.transform;
  const Quaternion q(t.rotation.x, t.rotation.y, t.rotation.z, t.rotation.w);
  if (child.empty() || parent.empty() || child == parent || !finite(t) || std::abs(q.length2() - 1) > 1e-2) {
    return false;
  }
  const Entry entry{parent, Vector3(t.translation.x, t.translation.y, t.translation.z), q};
  frames_.try_emplace(parent);
  Frame & frame = frames_[child];
  const std::int64_t time = std::int64_t{transform.header.stamp.sec} * 1'000'000'000 + transform.header.stamp.nanosec;
  if (is_static) {
    frame.fixed = entry;
  } else {
    if (!frame.data.empty() && time + cache_ < frame.data.rbegin()->first) {
      return false;
    }
    frame.data[time] = entry;
    frame.data.erase(frame.data.begin(), frame.data.lower_bound(frame.data.rbegin()->first - cache_));
  }
  changed();
  return true;
}

void BufferCore::require(const std::string & frame) const
{
  if (frame.empty()) {
    throw InvalidArgumentException("Invalid argument passed to lookupTransform: a frame_id cannot be empty");
  }
  if (frames_.count(frame) == 0) {
    throw LookupException("\"" + frame + "\" passed to lookupTransform argument does not exist.");
  }
}

std::string BufferCore::parent(const std::string & name) const
{
  const Frame & frame = frames_.at(name);
  return frame.fixed ? frame.fixed->parent : frame.data.empty() ? "" : frame.data.rbegin()->second.parent;
}

BufferCore::Path BufferCore::path(const std::string & frame) const
{
  Path found{frame};
  for (std::string up = parent(frame); !up.empty(); up = parent(up)) {
    found.push_back(up);
    if (found.size() > MOST_DEPTH) {
      throw LookupException("The tf tree is invalid because it contains a loop.");
    }
  }
  return found;
}

Transform BufferCore::at(const std::string & name, std::int64_t time) const
{
  const Frame & frame = frames_.at(name);
  if (frame.fixed) {
    return Transform(frame.fixed->rotation, frame.fixed->origin);
  }
  const auto & data = frame.data;
  const auto after = data.lower_bound(time);
  if (after != data.end() && after->first == time) {
    return Transform(after->second.rotation, after->second.origin);
  }
  if (data.size() == 1) {
    throw NoDataForExtrapolationException(
            "Lookup would require extrapolation at time " + seconds(time) + ", but only time " +
            seconds(data.begin()->first) + " is in the buffer, when looking up transform of frame [" + name + "]");
  }
  if (after == data.begin()) {
    throw BackwardExtrapolationException(
            "Lookup would require extrapolation into the past.  Requested time " + seconds(time) +
            " but the earliest data is at time " + seconds(data.begin()->first) +
            ", when looking up transform of frame [" + name + "]");
  }
  if (after == data.end()) {
    throw ForwardExtrapolationException(
            "Lookup would require extrapolation into the future.  Requested time " + seconds(time) +
            " but the latest data is at time " + seconds(data.rbegin()->first) +
            ", when looking up transform of frame [" + name + "]");
  }
  const auto before = std::prev(after);
  const double share =
    static_cast<double>(time - before->first) / static_cast<double>(after->first - before->first);
  return Transform(
    before->second.rotation.slerp(after->second.rotation, share),
    before->second.origin.lerp(after->second.origin, share));
}

Transform BufferCore::to_ancestor(const Path & path, std::size_t length, std::int64_t time) const
{
  Transform found;
  for (std::size_t i = 0; i < length; ++i) {
    found = at(path[i], time) * found;
  }
  return found;
}

geometry_msgs::msg::TransformStamped BufferCore::lookupTransform(
  const std::string & given_target, const std::string & given_source, const TimePoint & when) const
{
  const std::string target = plain(given_target), source = plain(given_source);
  require(target);
  require(source);
  const Path down = path(target), up = path(source);
  std::size_t i = 0, j = 0;
  bool met = false;
  for (i = 0; i < up.size() && !met; ++i) {
    const auto found = std::find(down.begin(), down.end(), up[i]);
    if (found != down.end()) {
      j = static_cast<std::size_t>(found - down.begin());
      met = true;
      break;
    }
  }
  if (!met) {
    throw ConnectivityException(
            "Could not find a connection between '" + target + "' and '" + source +
            "' because they are not part of the same tree. Tf has two or more unconnected trees.");
  }
  std::int64_t time = when.time_since_epoch().count();
  if (time == 0) {
    // The latest time for which all of the path is known.
    std::int64_t latest = INT64_MAX;
    for (const auto & [path_, length] : {std::pair<const Path *, std::size_t>(&up, i), {&down, j}}) {
      for (std::size_t k = 0; k < length; ++k) {
        const Frame & frame = frames_.at((*path_)[k]);
        if (!frame.fixed && !frame.data.empty()) {
          latest = std::min(latest, frame.data.rbegin()->first);
        }
      }
    }
    time = latest == INT64_MAX ? 0 : latest;
  }
  const Transform found = to_ancestor(down, j, time).inverse() * to_ancestor(up, i, time);
  geometry_msgs::msg::TransformStamped message;
  message.header.frame_id = target;
  message.header.stamp.sec = static_cast<std::int32_t>(time / 1'000'000'000);
  message.header.stamp.nanosec = static_cast<std::uint32_t>(time % 1'000'000'000);
  message.child_frame_id = source;
  message.transform.translation.x = found.getOrigin().x();
  message.transform.translation.y = found.getOrigin().y();
  message.transform.translation.z = found.getOrigin().z();
  const Quaternion q = found.getRotation();
  message.transform.rotation.x = q.x();
  message.transform.rotation.y = q.y();
  message.transform.rotation.z = q.z();
  message.transform.rotation.w = q.w();
  return message;
}

namespace {

Transform of(const geometry_msgs::msg::Transform & t)
{
  return Transform(
    Quaternion(t.rotation.x, t.rotation.y, t.rotation.z, t.rotation.w),
    Vector3(t.translation.x, t.translation.y, t.translation.z));
}

}  // namespace

geometry_msgs::msg::TransformStamped BufferCore::lookupTransform(
  const std::string & target, const TimePoint & target_time, const std::string & source, const TimePoint & source_time,
  const std::string & fixed) const
{
  auto message = lookupTransform(target, fixed, target_time);
  const auto first = lookupTransform(fixed, source, source_time);
  const Transform found = of(message.transform) * of(first.transform);
  message.child_frame_id = plain(source);
  message.transform.translation.x = found.getOrigin().x();
  message.transform.translation.y = found.getOrigin().y();
  message.transform.translation.z = found.getOrigin().z();
  const Quaternion q = found.getRotation();
  message.transform.rotation.x = q.x();
  message.transform.rotation.y = q.y();
  message.transform.rotation.z = q.z();
  message.transform.rotation.w = q.w();
  return message;
}

bool BufferCore::canTransform(
  const std::string & target, const std::string & source, const TimePoint & time, std::string * why) const
{
  try {
    lookupTransform(target, source, time);
    return true;
  } catch (const TransformException & e) {
    if (why != nullptr) {
      *why = e.what();
    }
    return false;
  }
}

bool BufferCore::canTransform(
  const std::string & target, const TimePoint & target_time, const std::string & source, const TimePoint & source_time,
  const std::string & fixed, std::string * why) const
{
  return canTransform(target, fixed, target_time, why) && canTransform(fixed, source, source_time, why);
}

std::vector<std::string> BufferCore::getAllFrameNames() const
{
  std::vector<std::string> names;
  for (const auto & [name, frame] : frames_) {
    (void)frame;
    names.push_back(name);
  }
  return names;
}

std::string BufferCore::allFramesAsYAML() const
{
  std::string text;
  for (const auto & [name, frame] : frames_) {
    (void)frame;
    const std::string up = parent(name);
    if (!up.empty()) {
      text += name + ":\n  parent: '" + up + "'\n";
    }
  }
  return text;
}

}  // namespace tf2
