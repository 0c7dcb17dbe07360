#include "simulation/operation_socket.hpp"

#include <sys/socket.h>
#include <sys/time.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>

namespace sitaf::simulation {
namespace {

/// Timeouts of one part of an exchange; the agent enforces a shorter limit for a case.
constexpr timeval pingTimeout{5, 0};
constexpr timeval timeout{300, 0};

using Header = std::array<unsigned char, 4>;

/// The length of a frame, little endian on every machine.
void writeLength(std::uint32_t length, char* at) {
  for (unsigned i = 0; i < Header().size(); ++i) {
    at[i] = static_cast<char>(length >> (8 * i));
  }
}

std::uint32_t lengthOf(const Header& header) {
  std::uint32_t length = 0;
  for (unsigned i = 0; i < header.size(); ++i) {
    length |= std::uint32_t{header[i]} << (8 * i);
  }
  return length;
}

void limit(int socket, const timeval& time) {
  setsockopt(socket, SOL_SOCKET, SO_RCVTIMEO, &time, sizeof(time));
  setsockopt(socket, SOL_SOCKET, SO_SNDTIMEO, &time, sizeof(time));
}

bool send(int socket, const std::string& bytes) {
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t count = ::send(socket, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
    if (count > 0) {
      sent += static_cast<std::size_t>(count);
    } else if (errno != EINTR) {
      return false;
    }
  }
  return true;
}

bool receive(int socket, char* to, std::size_t size) {
  for (std::size_t received = 0; received < size;) {
    errno = 0;
    const ssize_t count = ::recv(socket, to + received, size - received, 0);
    if (count > 0) {
      received += static_cast<std::size_t>(count);
    } else if (errno != EINTR) {
      return false;
    }
  }
  return true;
}

grpc::Status failure(const char* what) {
  const int error = errno;
  if (error == EAGAIN || error == EWOULDBLOCK) {
    return {grpc::DEADLINE_EXCEEDED, "no answer within " + std::to_string(timeout.tv_sec) + " s"};
  }
  return {grpc::UNAVAILABLE,
          std::string("the connection ended while ") + what + (error == 0 ? "" : std::string(": ") + std::strerror(error))};
}

}  // namespace

std::unique_ptr<OperationSocket> OperationSocket::open(const std::string& path) {
  sockaddr_un address{};
  if (path.size() >= sizeof(address.sun_path)) {
    return nullptr;
  }
  address.sun_family = AF_UNIX;
  std::memcpy(address.sun_path, path.c_str(), path.size());
  const int socket = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (socket < 0) {
    return nullptr;
  }
  std::unique_ptr<OperationSocket> opened(new OperationSocket(socket));
  limit(socket, pingTimeout);
  if (::connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0) {
    return nullptr;
  }
  sim::v1::OperateRequest ping;
  ping.mutable_ping();
  sim::v1::OperateResponse answer;
  if (!opened->exchange(ping, answer).ok()) {
    // The number of connections is limited.
    return nullptr;
  }
  limit(socket, timeout);
  return opened;
}

OperationSocket::~OperationSocket() {
  if (socket_ >= 0) {
    ::close(socket_);
  }
}

grpc::Status OperationSocket::operate(const sim::v1::OperateRequest& request, sim::v1::OperateResponse& response) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (socket_ < 0) {
    return {grpc::UNAVAILABLE, "the connection ended in an earlier call"};
  }
  grpc::Status status = exchange(request, response);
  if (!status.ok()) {
    // A late answer would be taken for that of the next operation.
    ::close(socket_);
    socket_ = -1;
    return status;
  }
  if (response.has_refusal()) {
    return {static_cast<grpc::StatusCode>(response.refusal().code()), response.refusal().message()};
  }
  return grpc::Status::OK;
}

grpc::Status OperationSocket::exchange(const sim::v1::OperateRequest& request, sim::v1::OperateResponse& response) {
  Header header{};
  const std::size_t size = request.ByteSizeLong();
  buffer_.resize(header.size() + size);
  writeLength(static_cast<std::uint32_t>(size), buffer_.data());
  request.SerializeWithCachedSizesToArray(reinterpret_cast<std::uint8_t*>(buffer_.data()) + header.size());
  if (!send(socket_, buffer_)) {
    return failure("sending");
  }
  if (!receive(socket_, reinterpret_cast<char*>(header.data()), header.size())) {
    return failure("receiving");
  }
  buffer_.resize(lengthOf(header));
  if (!receive(socket_, buffer_.data(), buffer_.size())) {
    return failure("receiving");
  }
  return response.ParseFromString(buffer_) ? grpc::Status::OK : grpc::Status(grpc::INTERNAL, "the answer cannot be read");
}

}  // namespace sitaf::simulation
