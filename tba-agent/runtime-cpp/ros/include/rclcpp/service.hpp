#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "rclcpp/client.hpp"

namespace rclcpp {

class ServiceBase : public sitaf_ros::Entity
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ServiceBase)

  ServiceBase(node_interfaces::NodeCore & node, const std::string & name, const std::string & type);
  ~ServiceBase() override;

  const char * get_service_name() const {return server_->name.c_str();}
  std::shared_ptr<ServiceBase> get_service_handle() {return std::static_pointer_cast<ServiceBase>(shared_from_this());}
  void configure_introspection(Clock::SharedPtr, const QoS &, rcl_service_introspection_state_t) {}
  bool exchange_in_use_by_wait_set_state(bool in_use) {return std::exchange(in_wait_set, in_use);}

  std::optional<std::pair<int, std::int64_t>> order() override;
  std::function<void()> take() override;

protected:
  void begin();
  virtual void handle(std::shared_ptr<rmw_request_id_t> id, sitaf_ros::Packet & request) = 0;
  void respond(const rmw_request_id_t & id, sitaf_ros::Packet response);
  bool next(sitaf_ros::Packet & request, rmw_request_id_t & id);

private:
  std::shared_ptr<sitaf_ros::Server> server_;
  std::deque<std::pair<std::int64_t, sitaf_ros::Packet>> requests_;
  std::map<std::int64_t, sitaf_ros::Respond> open_;
  std::int64_t asked_ = 0;
};

template<class S>
class Service : public ServiceBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Service<S>)

  using Request = typename S::Request;
  using Response = typename S::Response;
  using Callback = std::function<void(
        const std::shared_ptr<Service> &, const std::shared_ptr<rmw_request_id_t> &, const std::shared_ptr<Request> &)>;

  template<class F>
  Service(node_interfaces::NodeCore & node, const std::string & name, F callback)
  : ServiceBase(node, name, S::sitaf_name)
  {
    callback_ = Caller<F>{std::move(callback)};
  }
  void start() {begin();}

  void send_response(rmw_request_id_t & id, Response & response)
  {
    respond(id, sitaf_ros::packet<Response>(std::make_shared<const Response>(response)));
  }
  bool take_request(Request & request, rmw_request_id_t & id)
  {
    sitaf_ros::Packet packet;
    if (!next(packet, id)) {
      return false;
    }
    request = *packet.template shared<Request>();
    return true;
  }

protected:
  void handle(std::shared_ptr<rmw_request_id_t> id, sitaf_ros::Packet & request) override
  {
    callback_(
      std::static_pointer_cast<Service>(this->shared_from_this()), id,
      std::make_shared<Request>(*request.template shared<Request>()));
  }

private:
  /// Calls a callback of any of the forms that ROS accepts.
  template<class F>
  struct Caller
  {
    using Id = std::shared_ptr<rmw_request_id_t>;
    using Req = std::shared_ptr<Request>;
    using Resp = std::shared_ptr<Response>;
    F callback;

    void operator()(const std::shared_ptr<Service> & self, const Id & id, const Req & request)
    {
      if constexpr (std::is_invocable_v<F &, Req, Resp>) {
        Resp response = std::make_shared<Response>();
        callback(request, response);
        self->send_response(*id, *response);
      } else if constexpr (std::is_invocable_v<F &, Id, Req, Resp>) {
        Resp response = std::make_shared<Response>();
        callback(id, request, response);
        self->send_response(*id, *response);
      } else if constexpr (std::is_invocable_v<F &, Id, Req>) {
        callback(id, request);
      } else {
        callback(self, id, request);
      }
    }
  };

  Callback callback_;
};

}  // namespace rclcpp
