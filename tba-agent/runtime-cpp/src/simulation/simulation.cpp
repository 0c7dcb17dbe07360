#include "sitaf/simulation/simulation.hpp"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <optional>

#include "simulation/passing_time.hpp"
#include "simulation/pending_commands.hpp"
#include "simulation/simulated_hardware.hpp"
#include "simulation/wire.hpp"
#include "simulation/world_files.hpp"

namespace sitaf::simulation {
namespace {

namespace wire = sim::v1;
using Control = wire::SimulationControl::Stub;

/// The first batch is small, so that the first case starts soon; later batches grow.
constexpr std::size_t firstBatch = 64;
constexpr std::size_t largestBatch = 4096;
constexpr std::size_t growth = 8;

/// Simulation time between two frames of a recording: 50 frames per second.
constexpr std::int64_t frameNanos = 20000000;
constexpr std::size_t maxRecordedBytes = 64U << 20U;

wire::CreateSessionResponse create(Wire& wire, const std::string& worldDescription, std::uint64_t seed) {
  wire::CreateSessionRequest request;
  *request.mutable_world() = readWorld(worldDescription);
  request.set_seed(seed);
  const std::string file = worldDescription.substr(worldDescription.rfind('/') + 1);
  auto created = wire.control("opening the world " + file, &Control::CreateSession, request);
  if (created.world().timestep_ns() <= 0) {
    throw SimulationError("the simulator reported no timestep", false);
  }
  return created;
}

std::string describeParameters(const Simulation::Names& parameters, const std::vector<double>& values) {
  std::string text = "setting {";
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    text += (i == 0 ? "" : ", ") + parameters[i] + "=" + suite::literals::write(values[i]);
  }
  return text + "}";
}

/// Cases that were prepared in one call, and the next of them to run. Every case starts from a reset, so cases with the same values share
/// a row.
struct Batch {
  wire::PrepareManyResponse answer;
  std::vector<int> numbers;
  /// Index of the row of values and readings of each case.
  std::vector<std::size_t> rows;
  std::vector<double> values;
  std::size_t columns = 0;
  std::size_t parameters = 0;
  std::size_t cases = 0;
  std::size_t next = 0;

  bool diverged(std::size_t row) const {
    for (const auto found : answer.diverged_cases()) {
      if (found == row) {
        return true;
      }
    }
    return false;
  }

  /// Moves to a case; false when it is not among those that have not run yet. Cases before it are skipped.
  bool reaches(int no) {
    while (next < cases && numbers[next] != no) {
      ++next;
    }
    return next < cases;
  }

  /// The readings of the next case if it has the wanted values and did not diverge; otherwise null.
  const double* take(const std::vector<double>& wanted) {
    const std::size_t row = rows[next++];
    // Values are compared by their bits, so -0.0 and 0.0 differ.
    const bool same = parameters == 0 || (wanted.size() == parameters &&
                                          std::memcmp(wanted.data(), values.data() + row * parameters, parameters * sizeof(double)) == 0);
    return same && !diverged(row) ? answer.readings().data() + row * columns : nullptr;
  }
};

}  // namespace

class Simulation::Session : public Simulator {
 public:
  Session(const std::string& target, const std::string& worldDescription, std::uint64_t seed, runtime::Stopwatch& stopwatch)
      : wire_(target),
        created_(create(wire_, worldDescription, seed)),
        layout_(created_),
        pendingCommands_(created_.world()),
        world_(layout_),
        hardware_(layout_, world_, stopwatch, *this),
        time_(std::chrono::nanoseconds(created_.world().timestep_ns()), [this](std::uint64_t steps) { step(steps); }) {
    world_.freeze(created_.state());
    if (created_.operation_socket()) {
      wire_.useOperationSocket();
    }
    // Worlds that are prepared in bulk have no signals.
    alone_ = created_.keeps_signals();
    const auto& lease = created_.lease();
    lease_.emplace(wire_, created_.session_id(), std::chrono::milliseconds(lease.seconds() * 1000 + lease.nanos() / 1000000));
  }

  ~Session() override {
    time_.end();
    lease_.reset();
    wire::DeleteSessionRequest request;
    request.set_session_id(created_.session_id());
    try {
      wire_.control("closing the session", &Control::DeleteSession, request);
    } catch (const SimulationError&) {
      // A lost simulator has no session to delete.
    }
  }

  Hardware& hardware() { return hardware_; }

  void requireNotLost() { wire_.requireNotLost(); }

  void prepare(const Names& parameters, const std::vector<double>& values, std::chrono::nanoseconds settle,
               std::chrono::nanoseconds callAfter = std::chrono::nanoseconds(0)) {
    time_.restart(settle);
    // The reset would undo them.
    pendingCommands_.take();
    prepareSeparately({parameters, values, settle, callAfter});
  }

  void prepareAhead(const Names& parameters, const std::vector<double>& values, std::chrono::nanoseconds settle,
                    suite::Upcoming& upcoming) {
    const suite::TestCase* current = alone_ ? nullptr : upcoming.peek(0);
    if (current != nullptr && !batch_.reaches(current->no())) {
      fetch(parameters, settle, upcoming);
    }
    const bool prepared = current != nullptr && batch_.reaches(current->no());
    const double* row = prepared ? batch_.take(values) : nullptr;
    if (row == nullptr) {
      prepare(parameters, values, settle);
      return;
    }
    // The reset would undo them.
    pendingCommands_.take();
    pending_ = {parameters, values, settle, std::chrono::nanoseconds(0)};
    time_.restart(settle);
    const std::int64_t step = created_.world().timestep_ns();
    world_.freeze(std::chrono::nanoseconds((settle.count() + step - 1) / step * step), row);
  }

  void advance(std::chrono::nanoseconds time) { time_.pass(time); }

  PassingTime& time() { return time_; }

  void record(const std::string& folder) {
    recording_ = folder;
    std::filesystem::create_directories(folder);
    alone_ = true;
    wire::RecordMotionRequest request;
    request.set_session_id(created_.session_id());
    request.set_interval_ns(frameNanos);
    wire_.control("recording", &Control::RecordMotion, request);
  }

  std::size_t present() const {
    std::size_t bytes = 0;
    for (const auto& file : std::filesystem::directory_iterator(recording_)) {
      std::error_code taken;
      const auto size = file.file_size(taken);
      bytes += taken ? 0 : size;
    }
    return bytes;
  }

  void saveMotion(int no) {
    if (recording_.empty() || recordedBytes_ >= maxRecordedBytes) {
      return;
    }
    wire::TakeMotionRequest request;
    request.set_session_id(created_.session_id());
    wire::TakeMotionResponse taken;
    try {
      sendPending();
      taken = wire_.control("taking the recording of case " + std::to_string(no), &Control::TakeMotion, request);
    } catch (const SimulationError& e) {
      if (e.isLost()) {
        throw;
      }
      // The simulation diverged, so there is no recording.
      return;
    }
    if (recordedBytes_ + taken.gltf().size() > maxRecordedBytes) {
      // The agent may have removed files from the folder.
      recordedBytes_ = present();
    }
    recordedBytes_ += taken.gltf().size();
    if (recordedBytes_ <= maxRecordedBytes) {
      std::ofstream file(recording_ + "/" + std::to_string(no) + ".glb", std::ios::binary);
      file.write(taken.gltf().data(), static_cast<std::streamsize>(taken.gltf().size()));
    }
  }

  void caseBegins(int no) {
    caseNo_ = no;
    called_ = false;
  }

  void callBegins() {
    if (!called_) {
      called_ = true;
      callTime_ = world_.time();
    }
  }

  void beforeTimePasses(std::function<void(std::chrono::nanoseconds)> look) { beforeTimePasses_ = std::move(look); }

  std::chrono::nanoseconds now() const { return world_.time(); }

  std::chrono::nanoseconds sinceCall() const { return world_.time() - callTime_; }

  void set(const std::string& parameter, double value) {
    const std::lock_guard<std::recursive_mutex> lock(acting_);
    updateSession();
    sendPending();
    wire::SetParametersRequest request;
    request.set_session_id(created_.session_id());
    (*request.mutable_values())[parameter] = value;
    world_.freeze(wire_.set("setting " + parameter + " to " + suite::literals::write(value), std::move(request)));
  }

  void keepSignals(int no) {
    if (!created_.keeps_signals()) {
      return;
    }
    wire::KeepSignalsRequest request;
    request.set_session_id(created_.session_id());
    request.set_case_no(no);
    request.set_call_time_ns(callTime_.count());
    try {
      sendPending();
      wire_.control("keeping the signals of case " + std::to_string(no), &Control::KeepSignals, request);
    } catch (const SimulationError& e) {
      std::fprintf(stderr, "sitaf: %s\n", e.what());
    }
  }

  double observation(std::string_view name) {
    sendPending();
    const auto& names = layout_.observations();
    std::string existing;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (names[i] == name) {
        return world_.read(layout_.firstObservation() + i, [](const double* at) { return *at; });
      }
      existing += (existing.empty() ? "" : ", ") + names[i];
    }
    throw SimulationError("the world has no observation '" + std::string(name) + "'; it has [" + existing + "]", false);
  }

  void write(wire::DeviceCommand command) override {
    const std::lock_guard<std::recursive_mutex> lock(acting_);
    updateSession();
    if (pendingCommands_.isAcceptable(command)) {
      if (pendingCommands_.isFull()) {
        sendPending();
      }
      pendingCommands_.add(std::move(command));
      return;
    }
    sendPending();
    const std::string device = command.device();
    give("commanding " + device, {std::move(command)});
  }

  void sendPending() override {
    PendingCommands::Commands commands = pendingCommands_.take();
    if (!commands.empty()) {
      give("commanding devices", std::move(commands));
    }
  }

  wire::Image look(const std::string& camera) override {
    updateSession();
    sendPending();
    wire::ReadDevicesRequest request;
    request.set_session_id(created_.session_id());
    request.add_devices(camera);
    const auto answer = wire_.hardware("reading the camera " + camera, &wire::VirtualHardware::Stub::ReadDevices, request);
    if (answer.state().readings_size() == 0) {
      throw SimulationError("simulator: reading the camera " + camera + ": the response contains no image", false);
    }
    return answer.state().readings(0).image();
  }

  void sleep(std::chrono::nanoseconds time) override { advance(time); }

 private:
  struct Pending {
    Names parameters;
    std::vector<double> values;
    std::chrono::nanoseconds settle;
    std::chrono::nanoseconds callAfter;
  };

  void prepareSeparately(const Pending& prepared) {
    wire::PrepareRequest request;
    request.set_session_id(created_.session_id());
    for (std::size_t i = 0; i < prepared.parameters.size(); ++i) {
      (*request.mutable_parameters())[prepared.parameters[i]] = prepared.values[i];
    }
    request.set_settle_ns(prepared.settle.count());
    request.set_call_after_ns(prepared.callAfter.count());
    request.set_case_no(caseNo_);
    pending_.reset();
    world_.freeze(wire_.prepare(describeParameters(prepared.parameters, prepared.values), std::move(request)));
  }

  void give(const std::string& what, PendingCommands::Commands commands) {
    wire::WriteDevicesRequest request;
    request.set_session_id(created_.session_id());
    for (wire::DeviceCommand& command : commands) {
      *request.add_commands() = std::move(command);
    }
    world_.freeze(wire_.write(what, std::move(request)));
  }

  void step(std::uint64_t steps) {
    if (beforeTimePasses_) {
      beforeTimePasses_(world_.time());
    }
    updateSession();
    wire::StepSimulationRequest request;
    request.set_session_id(created_.session_id());
    request.set_steps(steps);
    for (wire::DeviceCommand& command : pendingCommands_.take()) {
      *request.add_commands() = std::move(command);
    }
    world_.freeze(wire_.step("advancing by " + std::to_string(steps) + " steps", std::move(request)));
  }

  /// Brings the session to the current case, because the component acts; later cases are prepared separately.
  void updateSession() {
    const std::lock_guard<std::recursive_mutex> lock(acting_);
    if (pending_) {
      const Pending pending = *pending_;
      alone_ = true;
      prepareSeparately(pending);
    }
  }

  /// Prepares the current and the following cases. When the simulator rejects one of them, each is prepared separately and reports its own
  /// failure.
  void fetch(const Names& parameters, std::chrono::nanoseconds settle, suite::Upcoming& upcoming) {
    batch_ = Batch();
    batch_.parameters = parameters.size();
    std::size_t count = 0;
    std::map<std::string, std::size_t> rows;
    std::vector<double> row(parameters.size());
    for (const suite::TestCase* ahead = nullptr; count < batchSize_ && (ahead = upcoming.peek(count)) != nullptr; ++count) {
      try {
        std::transform(parameters.begin(), parameters.end(), row.begin(),
                       [ahead](const std::string& name) { return ahead->value<double>(name); });
      } catch (const suite::CaseDataError&) {
        // Reported when that case is read.
        break;
      }
      const std::string bits(reinterpret_cast<const char*>(row.data()), row.size() * sizeof(double));
      const auto [at, isNew] = rows.try_emplace(bits, rows.size());
      if (isNew) {
        batch_.values.insert(batch_.values.end(), row.begin(), row.end());
      }
      batch_.rows.push_back(at->second);
      batch_.numbers.push_back(ahead->no());
    }
    batch_.cases = count;
    if (count < 2) {
      batch_.cases = 0;
      return;
    }
    wire::PrepareManyRequest request;
    request.set_session_id(created_.session_id());
    *request.mutable_parameters() = {parameters.begin(), parameters.end()};
    *request.mutable_values() = {batch_.values.begin(), batch_.values.end()};
    request.set_cases(static_cast<std::uint32_t>(rows.size()));
    request.set_settle_ns(settle.count());
    try {
      batch_.answer = wire_.control("preparing " + std::to_string(rows.size()) + " worlds", &Control::PrepareMany, request);
    } catch (const SimulationError& e) {
      if (e.isLost()) {
        throw;
      }
      batchSize_ = firstBatch;
      rejectBatch();
      return;
    }
    batch_.columns = static_cast<std::size_t>(batch_.answer.columns_size());
    const bool known =
        std::equal(batch_.answer.columns().begin(), batch_.answer.columns().end(), layout_.columns().begin(), layout_.columns().end());
    if (!known || batch_.answer.readings_size() != static_cast<int>(rows.size() * batch_.columns)) {
      alone_ = true;
      batch_.cases = 0;
      return;
    }
    batchSize_ = std::min(largestBatch, batchSize_ * growth);
  }

  /// Marks all rows as diverged, so that each case of this batch is prepared separately.
  void rejectBatch() {
    batch_.answer.Clear();
    const std::size_t rows = batch_.rows.empty() ? 0 : *std::max_element(batch_.rows.begin(), batch_.rows.end()) + 1;
    for (std::size_t i = 0; i < rows; ++i) {
      batch_.answer.add_diverged_cases(static_cast<std::uint32_t>(i));
    }
  }

  Wire wire_;
  const wire::CreateSessionResponse created_;
  const Layout layout_;
  PendingCommands pendingCommands_;
  FrozenWorld world_;
  SimulatedHardware hardware_;
  std::optional<Lease> lease_;
  std::function<void(std::chrono::nanoseconds)> beforeTimePasses_;
  PassingTime time_;
  std::recursive_mutex acting_;
  std::string recording_;
  std::size_t recordedBytes_ = 0;
  Batch batch_;
  std::size_t batchSize_ = firstBatch;
  std::optional<Pending> pending_;
  bool alone_ = false;
  std::chrono::nanoseconds callTime_{0};
  int caseNo_ = 0;
  bool called_ = false;
};

Simulation::Simulation(const std::string& target, const std::string& worldDescription, std::uint64_t seed, runtime::Stopwatch& stopwatch)
    : session_(std::make_unique<Session>(target, worldDescription, seed, stopwatch)) {}

Simulation::~Simulation() = default;

Hardware& Simulation::hardware() { return session_->hardware(); }

void Simulation::requireNotLost() { session_->requireNotLost(); }

void Simulation::prepare(const Names& parameters, const std::vector<double>& values, std::chrono::nanoseconds settle,
                         std::chrono::nanoseconds callAfter) {
  session_->prepare(parameters, values, settle, callAfter);
}

void Simulation::prepareAhead(const Names& parameters, const std::vector<double>& values, std::chrono::nanoseconds settle,
                              suite::Upcoming& upcoming) {
  session_->prepareAhead(parameters, values, settle, upcoming);
}

void Simulation::advance(std::chrono::nanoseconds time) { session_->advance(time); }

void Simulation::every(std::chrono::nanoseconds period, std::function<void()> task) { session_->time().every(period, std::move(task)); }

void Simulation::follow(std::thread::id thread) { session_->time().follow(thread); }

void Simulation::leave() { session_->time().leave(); }

bool Simulation::isDriver() { return session_->time().isDriver(); }

void Simulation::advanceUntilLeaves(std::thread::id thread) { session_->time().passUntilLeaves(thread); }

void Simulation::advanceUntil(std::thread::id thread, const std::function<bool()>& reached) { session_->time().passUntil(thread, reached); }

void Simulation::awaitTurnOf(std::thread::id thread) { session_->time().awaitTurnOf(thread); }

void Simulation::giveUp(std::thread::id thread) { session_->time().giveUp(thread); }

void Simulation::limitCases(std::chrono::nanoseconds most) { session_->time().limit(most); }

void Simulation::record(const std::string& folder) { session_->record(folder); }

void Simulation::caseBegins(int no) { session_->caseBegins(no); }

void Simulation::callBegins() { session_->callBegins(); }

void Simulation::beforeTimePasses(std::function<void(std::chrono::nanoseconds)> look) { session_->beforeTimePasses(std::move(look)); }

std::chrono::nanoseconds Simulation::now() const { return session_->now(); }

std::chrono::nanoseconds Simulation::sinceCall() const { return session_->sinceCall(); }

void Simulation::set(const std::string& parameter, double value) { session_->set(parameter, value); }

void Simulation::keepSignals(int no) { session_->keepSignals(no); }

void Simulation::saveMotion(int no) { session_->saveMotion(no); }

double Simulation::observation(std::string_view name) const { return session_->observation(name); }

}  // namespace sitaf::simulation
