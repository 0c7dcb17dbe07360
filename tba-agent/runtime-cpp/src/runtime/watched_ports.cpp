#include "sitaf/runtime/watched_ports.hpp"

namespace sitaf::runtime {

void WatchedPorts::watch(std::string signal, Read read, Duration now) {
  Port port;
  port.changes.signal = std::move(signal);
  port.read = std::move(read);
  this->read(port, now);
  ports_.push_back(std::move(port));
}

void WatchedPorts::take(Duration now) {
  // A port may itself let time pass.
  if (reading_ || failure_) {
    return;
  }
  reading_ = true;
  try {
    for (Port& port : ports_) {
      read(port, now);
    }
  } catch (...) {
    failure_ = std::current_exception();
  }
  reading_ = false;
}

void WatchedPorts::requireRead() {
  const std::exception_ptr thrown = std::exchange(failure_, nullptr);
  if (thrown) {
    std::rethrow_exception(thrown);
  }
}

void WatchedPorts::writeTo(suite::CaseResult& result, Duration call) const {
  for (const Port& port : ports_) {
    suite::PortChanges changes = port.changes;
    for (auto& change : changes.changes) {
      change.first -= call;
    }
    result.addPort(std::move(changes));
  }
}

void WatchedPorts::clear() {
  ports_.clear();
  count_ = 0;
  failure_ = nullptr;
}

void WatchedPorts::read(Port& port, Duration now) {
  std::string literal = port.read();
  auto& changes = port.changes.changes;
  if (!changes.empty() && changes.back().second == literal) {
    return;
  }
  if (!changes.empty() && changes.back().first == now) {
    changes.back().second = std::move(literal);
  } else if (count_ < mostChanges) {
    ++count_;
    changes.emplace_back(now, std::move(literal));
  } else {
    ++port.changes.leftOut;
  }
}

}  // namespace sitaf::runtime
