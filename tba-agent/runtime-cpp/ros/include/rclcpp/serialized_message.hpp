// Serialized messages, and what is known about a message that was received.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <algorithm>
#include <memory>

#include "rclcpp/macros.hpp"
#include "sitaf_ros/graph.hpp"

typedef struct rcutils_allocator_s
{
  void * state;
} rcutils_allocator_t;
typedef rcutils_allocator_t rcl_allocator_t;
inline rcutils_allocator_t rcutils_get_default_allocator() {return {nullptr};}
inline rcl_allocator_t rcl_get_default_allocator() {return {nullptr};}

typedef struct rcutils_uint8_array_s
{
  std::uint8_t * buffer;
  std::size_t buffer_length, buffer_capacity;
  rcutils_allocator_t allocator;
} rcutils_uint8_array_t;
typedef rcutils_uint8_array_t rcl_serialized_message_t;
typedef rcutils_uint8_array_t rmw_serialized_message_t;

typedef struct rmw_gid_s
{
  std::uint8_t data[16];
} rmw_gid_t;
typedef struct rmw_message_info_s
{
  std::int64_t source_timestamp, received_timestamp;
  std::uint64_t publication_sequence_number, reception_sequence_number;
  rmw_gid_t publisher_gid;
  bool from_intra_process;
} rmw_message_info_t;
typedef struct rmw_request_id_s
{
  std::int8_t writer_guid[16];
  std::int64_t sequence_number;
} rmw_request_id_t;
typedef struct rmw_service_info_s
{
  std::int64_t source_timestamp, received_timestamp;
  rmw_request_id_t request_id;
} rmw_service_info_t;

namespace rclcpp {

class SerializedMessage
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(SerializedMessage)

  SerializedMessage() = default;
  explicit SerializedMessage(const rcl_allocator_t &) {}
  explicit SerializedMessage(std::size_t capacity, const rcl_allocator_t & = rcl_get_default_allocator())
  {
    reserve(capacity);
  }
  explicit SerializedMessage(sitaf_ros::Bytes bytes)
  : bytes_(std::move(bytes)), has_length_(true) {}
  SerializedMessage(const SerializedMessage & other)
  : bytes_(other.get()), has_length_(true) {}
  SerializedMessage & operator=(const SerializedMessage & other)
  {
    bytes_ = other.get();
    has_length_ = true;
    return *this;
  }
  virtual ~SerializedMessage() = default;

  rcl_serialized_message_t & get_rcl_serialized_message()
  {
    if (has_length_) {
      raw_ = {bytes_.data(), bytes_.size(), bytes_.size(), {}};
      has_length_ = false;
    }
    return raw_;
  }
  const rcl_serialized_message_t & get_rcl_serialized_message() const
  {
    return const_cast<SerializedMessage *>(this)->get_rcl_serialized_message();
  }
  std::size_t size() const {return get_rcl_serialized_message().buffer_length;}
  std::size_t capacity() const {return get_rcl_serialized_message().buffer_capacity;}
  void reserve(std::size_t capacity)
  {
    const std::size_t length = size();
    bytes_.resize(std::max(capacity, bytes_.size()));
    raw_ = {bytes_.data(), length, bytes_.size(), {}};
    has_length_ = false;
  }
  rcl_serialized_message_t release_rcl_serialized_message() {return get_rcl_serialized_message();}

  sitaf_ros::Bytes get() const
  {
    const auto & raw = get_rcl_serialized_message();
    return sitaf_ros::Bytes(raw.buffer, raw.buffer + raw.buffer_length);
  }

private:
  sitaf_ros::Bytes bytes_;
  bool has_length_ = true;
  rcl_serialized_message_t raw_{};
};

class SerializationBase
{
public:
  virtual ~SerializationBase() = default;
};

template<class M>
class Serialization : public SerializationBase
{
public:
  void serialize_message(const void * message, SerializedMessage * serialized) const
  {
    sitaf_ros::Bytes bytes;
    sitaf_ros::type_support<M>().write(message, bytes);
    *serialized = SerializedMessage(std::move(bytes));
  }
  void deserialize_message(const SerializedMessage * serialized, void * message) const
  {
    const auto read = sitaf_ros::type_support<M>().read(serialized->get());
    *static_cast<M *>(message) = std::move(*static_cast<M *>(read.get()));
  }
};

class MessageInfo
{
public:
  MessageInfo() = default;
  explicit MessageInfo(const rmw_message_info_t & info)
  : info_(info) {}
  const rmw_message_info_t & get_rmw_message_info() const {return info_;}
  rmw_message_info_t & get_rmw_message_info() {return info_;}

private:
  rmw_message_info_t info_{};
};

}  // namespace rclcpp
