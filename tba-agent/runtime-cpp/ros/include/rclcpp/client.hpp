#pragma once

#include <deque>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <variant>

#include "rclcpp/publisher.hpp"

typedef enum
{
  RCL_SERVICE_INTROSPECTION_OFF, RCL_SERVICE_INTROSPECTION_METADATA, RCL_SERVICE_INTROSPECTION_CONTENTS
} rcl_service_introspection_state_t;

namespace rclcpp {

class ClientBase : public sitaf_ros::Entity
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ClientBase)

  ClientBase(node_interfaces::NodeCore & node, const std::string & name, const std::string & type);
  ~ClientBase() override;

  const char * get_service_name() const {return calling_->name.c_str();}
  bool service_is_ready() const;
  template<class R = std::int64_t, class P = std::milli>
  bool wait_for_service(std::chrono::duration<R, P> time = std::chrono::duration<R, P>(-1))
  {
    return wait(time.count() < 0 ? -1 : std::chrono::duration_cast<std::chrono::nanoseconds>(time).count());
  }
  std::shared_ptr<ClientBase> get_client_handle() {return std::static_pointer_cast<ClientBase>(shared_from_this());}
  void configure_introspection(Clock::SharedPtr, const QoS &, rcl_service_introspection_state_t) {}
  bool exchange_in_use_by_wait_set_state(bool in_use) {return std::exchange(in_wait_set, in_use);}

  std::optional<std::pair<int, std::int64_t>> order() override;
  std::function<void()> take() override;

protected:
  std::int64_t send(sitaf_ros::Packet request);
  virtual void handle(std::int64_t id, sitaf_ros::Packet & response) = 0;

private:
  bool wait(sitaf_ros::Nanos nanos);
  std::shared_ptr<sitaf_ros::Calling> calling_;
  std::deque<std::pair<std::int64_t, sitaf_ros::Packet>> responses_;
  std::int64_t sent_ = 0;
};

template<class S>
class Client : public ClientBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Client<S>)

  using Request = typename S::Request;
  using Response = typename S::Response;
  using SharedRequest = std::shared_ptr<Request>;
  using SharedResponse = std::shared_ptr<Response>;
  using Promise = std::promise<SharedResponse>;
  using PromiseWithRequest = std::promise<std::pair<SharedRequest, SharedResponse>>;
  using SharedPromise = std::shared_ptr<Promise>;
  using Future = std::future<SharedResponse>;
  using SharedFuture = std::shared_future<SharedResponse>;
  using SharedFutureWithRequest = std::shared_future<std::pair<SharedRequest, SharedResponse>>;
  using CallbackType = std::function<void (SharedFuture)>;
  using CallbackWithRequestType = std::function<void (SharedFutureWithRequest)>;

  template<class F>
  struct WithId
  {
    F future;
    std::int64_t request_id;

    operator F &() {return future;}
    operator F() {return std::move(future);}
    auto get() {return future.get();}
    bool valid() const noexcept {return future.valid();}
    void wait() const {future.wait();}
    template<class R, class P>
    std::future_status wait_for(const std::chrono::duration<R, P> & time) const {return future.wait_for(time);}
    template<class C, class D>
    std::future_status wait_until(const std::chrono::time_point<C, D> & time) const {return future.wait_until(time);}
    auto share() {return future.share();}
  };
  using FutureAndRequestId = WithId<Future>;
  using SharedFutureAndRequestId = WithId<SharedFuture>;
  using SharedFutureWithRequestAndRequestId = WithId<SharedFutureWithRequest>;

  Client(node_interfaces::NodeCore & node, const std::string & name)
  : ClientBase(node, name, S::sitaf_name) {}

  FutureAndRequestId async_send_request(SharedRequest request)
  {
    auto promise = std::make_shared<Promise>();
    Future future = promise->get_future();
    return {std::move(future), begin(request, [promise](SharedResponse response) {promise->set_value(response);})};
  }
  template<class F, std::enable_if_t<std::is_invocable_v<F &, SharedFuture>> * = nullptr>
  SharedFutureAndRequestId async_send_request(SharedRequest request, F callback)
  {
    auto promise = std::make_shared<Promise>();
    SharedFuture future = promise->get_future().share();
    auto done = [promise, future, callback](SharedResponse response) mutable {
        promise->set_value(response);
        callback(future);
      };
    return {future, begin(request, done)};
  }
  template<
    class F,
    std::enable_if_t<std::is_invocable_v<F &, SharedFutureWithRequest> && !std::is_invocable_v<F &, SharedFuture>> * =
    nullptr>
  SharedFutureWithRequestAndRequestId async_send_request(SharedRequest request, F callback)
  {
    auto promise = std::make_shared<PromiseWithRequest>();
    SharedFutureWithRequest future = promise->get_future().share();
    auto done = [promise, future, callback, request](SharedResponse response) mutable {
        promise->set_value({request, response});
        callback(future);
      };
    return {future, begin(request, done)};
  }

  bool remove_pending_request(std::int64_t id) {return pending_.erase(id) > 0;}
  template<class F>
  bool remove_pending_request(const WithId<F> & future) {return remove_pending_request(future.request_id);}
  std::size_t prune_pending_requests()
  {
    const std::size_t count = pending_.size();
    pending_.clear();
    return count;
  }
  template<class T, class A = std::allocator<std::int64_t>>
  std::size_t prune_requests_older_than(T time, std::vector<std::int64_t, A> * pruned = nullptr)
  {
    std::size_t count = 0;
    for (auto it = pending_.begin(); it != pending_.end();) {
      if (std::chrono::system_clock::time_point(std::chrono::nanoseconds(it->second.first)) < time) {
        if (pruned != nullptr) {
          pruned->push_back(it->first);
        }
        it = pending_.erase(it);
        ++count;
      } else {
        ++it;
      }
    }
    return count;
  }

protected:
  void handle(std::int64_t id, sitaf_ros::Packet & response) override
  {
    const auto found = pending_.find(id);
    if (found == pending_.end()) {
      return;
    }
    const auto done = std::move(found->second.second);
    pending_.erase(found);
    done(std::make_shared<Response>(*response.template shared<Response>()));
  }

private:
  template<class F>
  std::int64_t begin(const SharedRequest & request, F done)
  {
    const std::int64_t id = send(sitaf_ros::packet<Request>(std::make_shared<const Request>(*request)));
    pending_[id] = {sitaf_ros::EPOCH + sitaf_ros::kernel::now(), done};
    return id;
  }

  std::map<std::int64_t, std::pair<sitaf_ros::Nanos, std::function<void(SharedResponse)>>> pending_;
};

}  // namespace rclcpp
