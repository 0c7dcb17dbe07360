#pragma once

#include <grpcpp/grpcpp.h>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "simulation/operation_socket.hpp"
#include "sitaf/sim/v1/simulation.grpc.pb.h"

namespace sitaf::simulation {

/// Client of the simulator's services; failures throw exceptions.
class Wire {
 public:
  explicit Wire(const std::string& target);

  /// Makes a unary call of SimulationControl; a failure throws a SimulationError that names the operation.
  template <class Request, class Response>
  Response control(const std::string& what,
                   grpc::Status (sim::v1::SimulationControl::Stub::*rpc)(grpc::ClientContext*, const Request&, Response*),
                   const Request& request) {
    return call<Response>(
        what, false, [&](grpc::ClientContext* context, Response* response) { return (control_.get()->*rpc)(context, request, response); });
  }

  /// Runs operations over the simulator's socket of operations from now on, unless it cannot be reached.
  void useOperationSocket();

  /// Prepares a case; as control. Returns the state after it, as the following operations do.
  sim::v1::WorldState prepare(const std::string& what, sim::v1::PrepareRequest request);

  /// Sets parameters; as control.
  sim::v1::WorldState set(const std::string& what, sim::v1::SetParametersRequest request);

  /// Advances time. If it contains commands, their rejection is an error of the component and throws std::invalid_argument.
  sim::v1::WorldState step(const std::string& what, sim::v1::StepSimulationRequest request);

  /// Commands devices. A command that a device rejects is an error of the component and throws std::invalid_argument.
  sim::v1::WorldState write(const std::string& what, sim::v1::WriteDevicesRequest request);

  /// As control, for VirtualHardware. A command that a device rejects is an error of the component and throws std::invalid_argument.
  template <class Request, class Response>
  Response hardware(const std::string& what,
                    grpc::Status (sim::v1::VirtualHardware::Stub::*rpc)(grpc::ClientContext*, const Request&, Response*),
                    const Request& request) {
    return call<Response>(
        what, true, [&](grpc::ClientContext* context, Response* response) { return (hardware_.get()->*rpc)(context, request, response); });
  }

  /// Throws SimulationError when an earlier call found the simulator or the session lost, even if the component caught the exception.
  void requireNotLost();

 private:
  static void limit(grpc::ClientContext& context);
  void require(const grpc::Status& status, const std::string& what, bool ofComponent);

  sim::v1::WorldState operate(const std::string& what, bool ofComponent, const sim::v1::OperateRequest& request);

  template <class Response, class Call>
  Response call(const std::string& what, bool ofComponent, Call make) {
    grpc::ClientContext context;
    limit(context);
    Response response;
    require(make(&context, &response), what, ofComponent);
    return response;
  }

  const std::string target_;
  std::unique_ptr<OperationSocket> operations_;
  std::mutex mutex_;
  std::string gone_;
  std::unique_ptr<sim::v1::SimulationControl::Stub> control_;
  std::unique_ptr<sim::v1::VirtualHardware::Stub> hardware_;
};

/// Renews the lease of a session in the background, so that it does not expire during a long call of the component.
class Lease {
 public:
  Lease(Wire& wire, std::string session, std::chrono::milliseconds length);
  ~Lease();
  Lease(const Lease&) = delete;
  Lease& operator=(const Lease&) = delete;

 private:
  std::mutex mutex_;
  std::condition_variable ended_;
  bool over_ = false;
  std::thread clock_;
};

}  // namespace sitaf::simulation
