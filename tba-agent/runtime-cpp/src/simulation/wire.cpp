#include "simulation/wire.hpp"

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "sitaf/simulation/simulation_error.hpp"

namespace sitaf::simulation {

namespace wire = sim::v1;

namespace {

/// Timeout of a call to the simulator; the agent enforces a shorter limit for a case.
constexpr std::chrono::minutes callTimeout{5};
constexpr int maxMessageBytes = 64 << 20;
constexpr std::chrono::milliseconds shortestRenewal{100};

std::shared_ptr<grpc::Channel> channelTo(const std::string& target) {
  grpc::ChannelArguments arguments;
  arguments.SetMaxReceiveMessageSize(maxMessageBytes);
  arguments.SetMaxSendMessageSize(2 * maxMessageBytes);
  arguments.SetInt(GRPC_ARG_ENABLE_HTTP_PROXY, 0);
  return grpc::CreateCustomChannel(target, grpc::InsecureChannelCredentials(), arguments);
}

const char* nameOf(grpc::StatusCode code) {
  static constexpr const char* names[] = {"OK",        "CANCELLED",      "UNKNOWN",           "INVALID_ARGUMENT",   "DEADLINE_EXCEEDED",
                                          "NOT_FOUND", "ALREADY_EXISTS", "PERMISSION_DENIED", "RESOURCE_EXHAUSTED", "FAILED_PRECONDITION",
                                          "ABORTED",   "OUT_OF_RANGE",   "UNIMPLEMENTED",     "INTERNAL",           "UNAVAILABLE",
                                          "DATA_LOSS", "UNAUTHENTICATED"};
  return code >= 0 && code < static_cast<int>(std::size(names)) ? names[code] : "UNKNOWN";
}

bool isLost(grpc::StatusCode code) {
  switch (code) {
    case grpc::INVALID_ARGUMENT:
    case grpc::OUT_OF_RANGE:
    case grpc::DATA_LOSS:
    case grpc::RESOURCE_EXHAUSTED:
    case grpc::FAILED_PRECONDITION:
      return false;
    default:
      return true;
  }
}

}  // namespace

Wire::Wire(const std::string& target) : target_(target) {
  const auto channel = channelTo(target);
  control_ = sim::v1::SimulationControl::NewStub(channel);
  hardware_ = sim::v1::VirtualHardware::NewStub(channel);
}

void Wire::useOperationSocket() {
  static const std::string unixScheme = "unix:";
  if (target_.rfind(unixScheme, 0) == 0) {
    operations_ = OperationSocket::open(target_.substr(unixScheme.size()) + ".ops");
  }
}

wire::WorldState Wire::operate(const std::string& what, bool ofComponent, const wire::OperateRequest& request) {
  wire::OperateResponse response;
  require(operations_->operate(request, response), what, ofComponent);
  return std::move(*response.mutable_state());
}

wire::WorldState Wire::prepare(const std::string& what, wire::PrepareRequest request) {
  if (operations_) {
    wire::OperateRequest operation;
    operation.mutable_prepare()->Swap(&request);
    return operate(what, false, operation);
  }
  return control(what, &wire::SimulationControl::Stub::Prepare, request).state();
}

wire::WorldState Wire::set(const std::string& what, wire::SetParametersRequest request) {
  if (operations_) {
    wire::OperateRequest operation;
    operation.mutable_set_parameters()->Swap(&request);
    return operate(what, false, operation);
  }
  return control(what, &wire::SimulationControl::Stub::SetParameters, request).state();
}

wire::WorldState Wire::step(const std::string& what, wire::StepSimulationRequest request) {
  const bool commands = request.commands_size() > 0;
  if (operations_) {
    wire::OperateRequest operation;
    operation.mutable_step()->Swap(&request);
    return operate(what, commands, operation);
  }
  return call<wire::StepSimulationResponse>(
             what, commands, [&](auto* context, auto* response) { return control_->StepSimulation(context, request, response); })
      .state();
}

wire::WorldState Wire::write(const std::string& what, wire::WriteDevicesRequest request) {
  if (operations_) {
    wire::OperateRequest operation;
    operation.mutable_write()->Swap(&request);
    return operate(what, true, operation);
  }
  return hardware(what, &wire::VirtualHardware::Stub::WriteDevices, request).state();
}

void Wire::limit(grpc::ClientContext& context) { context.set_deadline(std::chrono::system_clock::now() + callTimeout); }

void Wire::require(const grpc::Status& status, const std::string& what, bool ofComponent) {
  if (status.ok()) {
    return;
  }
  const grpc::StatusCode code = status.error_code();
  if (ofComponent && (code == grpc::INVALID_ARGUMENT || code == grpc::OUT_OF_RANGE)) {
    throw std::invalid_argument(status.error_message());
  }
  const std::string reason = status.error_message().empty() ? "" : ": " + status.error_message();
  const std::string message = "simulator: " + what + ": " + nameOf(code) + reason;
  if (code == grpc::UNAVAILABLE || code == grpc::NOT_FOUND) {
    const std::lock_guard<std::mutex> lock(mutex_);
    gone_ = message;
  }
  throw SimulationError(message, isLost(code));
}

void Wire::requireNotLost() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!gone_.empty()) {
    throw SimulationError("the simulator is gone: " + gone_, true);
  }
}

Lease::Lease(Wire& wire, std::string session, std::chrono::milliseconds length)
    : clock_([this, &wire, session = std::move(session), period = std::max(shortestRenewal, length / 3)] {
        sim::v1::RenewSessionRequest request;
        request.set_session_id(session);
        std::unique_lock<std::mutex> lock(mutex_);
        while (!ended_.wait_for(lock, period, [this] { return over_; })) {
          lock.unlock();
          try {
            wire.control("renewing the session", &sim::v1::SimulationControl::Stub::RenewSession, request);
          } catch (const SimulationError&) {
            // The next call of the test driver fails in the same way and reports it.
          }
          lock.lock();
        }
      }) {}

Lease::~Lease() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    over_ = true;
  }
  ended_.notify_all();
  clock_.join();
}

}  // namespace sitaf::simulation
