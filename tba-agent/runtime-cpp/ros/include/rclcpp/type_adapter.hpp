#pragma once

#include <type_traits>

#include "sitaf_ros/type_support.hpp"

namespace rclcpp {

template<class Custom, class Ros = void, class Enable = void>
struct TypeAdapter
{
  using is_specialized = std::false_type;
  using custom_type = Custom;
  using ros_message_type = Custom;
};

template<class T>
struct is_type_adapter : std::false_type {};
template<class ... Ts>
struct is_type_adapter<TypeAdapter<Ts...>>: TypeAdapter<Ts...>::is_specialized {};

template<class T>
struct ImplicitTypeAdapter {using is_specialized = std::false_type;};

template<class T>
struct adapt_type
{
  template<class Ros>
  using as = TypeAdapter<T, Ros>;
};

#define RCLCPP_USING_CUSTOM_TYPE_AS_ROS_MESSAGE_TYPE(Custom, Ros) \
  template<> \
  struct rclcpp::ImplicitTypeAdapter<Custom> : public rclcpp::TypeAdapter<Custom, Ros> {}

}  // namespace rclcpp

namespace sitaf_ros {

/// What a publisher or subscription of T sends and what its user has.
template<class T, class = void>
struct Adapted
{
  using Ros = T;
  using Custom = T;
  static constexpr bool adapts = false;
};
template<class T>
struct Adapted<T, std::enable_if_t<rclcpp::is_type_adapter<T>::value>>
{
  using Ros = typename T::ros_message_type;
  using Custom = typename T::custom_type;
  using Adapter = T;
  static constexpr bool adapts = true;
};
template<class T>
struct Adapted<T, std::enable_if_t<rclcpp::ImplicitTypeAdapter<T>::is_specialized::value>>
{
  using Adapter = rclcpp::ImplicitTypeAdapter<T>;
  using Ros = typename Adapter::ros_message_type;
  using Custom = typename Adapter::custom_type;
  static constexpr bool adapts = true;
};

}  // namespace sitaf_ros
