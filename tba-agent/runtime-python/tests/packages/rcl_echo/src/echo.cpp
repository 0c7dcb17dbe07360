// A node that answers each message, on the C library rcl and the C++ types of messages.
#include <csignal>
#include <cstdio>
#include <stdexcept>
#include <string>
#include "rcl/error_handling.h"
#include "rcl/rcl.h"
#include "rosidl_typesupport_cpp/message_type_support.hpp"
#include "std_msgs/msg/string.hpp"
#include "text.hpp"

using std_msgs::msg::String;
static volatile std::sig_atomic_t ended = 0;

int main(int argc, char ** argv)
{
  std::signal(SIGINT, [](int) {ended = 1;});
  rcl_init_options_t options = rcl_get_zero_initialized_init_options();
  rcl_context_t context = rcl_get_zero_initialized_context();
  if (rcl_init_options_init(&options, rcl_get_default_allocator()) || rcl_init(argc, argv, &options, &context)) {
    throw std::runtime_error(rcl_get_error_string().str);
  }
  rcl_node_t node = rcl_get_zero_initialized_node();
  rcl_node_options_t node_options = rcl_node_get_default_options();
  (void)rcl_node_init(&node, "echo", "", &context, &node_options);
  auto type = rosidl_typesupport_cpp::get_message_type_support_handle<String>();
  rcl_publisher_t out = rcl_get_zero_initialized_publisher();
  rcl_publisher_options_t out_options = rcl_publisher_get_default_options();
  (void)rcl_publisher_init(&out, &node, type, "out", &out_options);
  rcl_subscription_t in = rcl_get_zero_initialized_subscription();
  rcl_subscription_options_t in_options = rcl_subscription_get_default_options();
  (void)rcl_subscription_init(&in, &node, type, "in", &in_options);
  rcl_wait_set_t waits = rcl_get_zero_initialized_wait_set();
  (void)rcl_wait_set_init(&waits, 1, 0, 0, 0, 0, 0, &context, rcl_get_default_allocator());
  while (!ended) {
    (void)rcl_wait_set_clear(&waits);
    (void)rcl_wait_set_add_subscription(&waits, &in, nullptr);
    if (rcl_wait(&waits, 100'000'000) != RCL_RET_OK || !waits.subscriptions[0]) {
      rcl_reset_error();
      continue;
    }
    String message;
    while (rcl_take(&in, &message, nullptr, nullptr) == RCL_RET_OK) {
      if (message.data == "stop") {throw std::runtime_error("stop requested");}
      String answer;
      answer.data = answer_to(message.data);
      (void)rcl_publish(&out, &answer, nullptr);
    }
    rcl_reset_error();
  }
  std::puts("ended");
  (void)rcl_shutdown(&context);
}
