// What the graph knows about a type of messages.
#pragma once

#include <memory>
#include <string>
#include <type_traits>

#include "sitaf_ros/cdr.hpp"

namespace sitaf_ros {

struct TypeSupport
{
  /// Such as `std_msgs/msg/String`.
  std::string name;
  void (* write)(const void * message, Bytes & out);
  std::shared_ptr<void> (* read)(const Bytes & bytes);
};

template<class M>
const TypeSupport & type_support()
{
  static const TypeSupport support{
    M::sitaf_name,
    [](const void * message, Bytes & out) {
      Writer writer(out);
      writer(*static_cast<const M *>(message));
    },
    [](const Bytes & bytes) -> std::shared_ptr<void> {
      auto message = std::make_shared<M>();
      Reader reader(bytes.data(), bytes.size());
      reader(*message);
      return message;
    }};
  return support;
}

template<class T, class = void>
struct IsMessage : std::false_type {};
template<class T>
struct IsMessage<T, std::void_t<decltype(T::sitaf_name)>> : std::true_type {};

}  // namespace sitaf_ros

namespace rosidl_generator_traits {

template<class T>
struct is_message : sitaf_ros::IsMessage<T> {};

template<class T>
inline const char * name() {return T::sitaf_name;}

template<class T>
inline const char * data_type() {return T::sitaf_name;}

}  // namespace rosidl_generator_traits
