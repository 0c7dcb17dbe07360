// Topics and services of a case: who publishes, who subscribes, who answers, and which qualities of service match.
#pragma once

#include <deque>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "sitaf_ros/kernel.hpp"
#include "sitaf_ros/type_support.hpp"

namespace sitaf_ros {

constexpr Nanos INFINITE = std::numeric_limits<Nanos>::max();

/// What a publisher offers or a subscription requests; the names are those of ROS's policies.
struct Quality
{
  std::size_t depth = 10;
  bool keep_all = false;
  bool reliable = true;
  bool transient_local = false;
  Nanos deadline = INFINITE;
  bool manual_liveliness = false;
  Nanos lease = INFINITE;
  Nanos lifespan = INFINITE;
};

/// The policy that keeps the two from matching; nullptr if they match.
const char * incompatible(const Quality & offered, const Quality & requested);

struct Publication;

/// A message on its way: its place in the order of publications, and when it was published.
struct Packet
{
  std::int64_t number = 0;
  Nanos time = 0;
  const TypeSupport * type = nullptr;
  std::shared_ptr<const void> message;
  std::shared_ptr<const Bytes> bytes;
  std::uint64_t publisher = 0;

  const Bytes & serialized();
  /// A message that others may hold, too.
  template<class M>
  std::shared_ptr<const M> shared()
  {
    if (message == nullptr) {
      type = &type_support<M>();
      message = type->read(*bytes);
    }
    return std::static_pointer_cast<const M>(message);
  }
};

template<class M>
Packet packet(std::shared_ptr<const M> message)
{
  Packet made;
  made.type = &type_support<M>();
  made.message = std::move(message);
  return made;
}

/// What the graph tells a publisher or subscription.
struct Endpoint
{
  virtual ~Endpoint() = default;
  virtual void matched(int) {}
  virtual void incompatible_with(const char *) {}
  virtual void alive(int) {}
  virtual void receive(const Packet &) {}
};

struct Publication
{
  std::string topic;
  std::string type;
  Quality quality;
  Endpoint * owner;
  /// The full name of the node; empty for the test.
  std::string node;
  std::uint64_t id = 0;
  std::deque<Packet> kept{};
  std::size_t sent = 0;
};

struct Subscribed
{
  std::string topic;
  std::string type;
  Quality quality;
  Endpoint * owner;
  std::string node;
  std::size_t received = 0;
};

using Respond = std::function<void (Packet)>;

struct Server
{
  std::string name;
  std::string type;
  std::function<void(Packet, Respond)> ask;
  std::string node;
};

struct Calling
{
  std::string name;
  std::string type;
  std::string node;
};

class Graph
{
public:
  static Graph & get();

  std::int64_t next_number() {return ++numbers_;}

  void add(const std::shared_ptr<Publication> & publication);
  void remove(const std::shared_ptr<Publication> & publication);
  void publish(Publication & publication, Packet packet);
  void add(const std::shared_ptr<Subscribed> & subscribed);
  void remove(const std::shared_ptr<Subscribed> & subscribed);
  void alive(const Publication & publication, int change);
  void add(const std::shared_ptr<Server> & server);
  void remove(const std::shared_ptr<Server> & server);
  void add(const std::shared_ptr<Calling> & calling);
  void remove(const std::shared_ptr<Calling> & calling);
  std::shared_ptr<Server> server(const std::string & name, const std::string & type) const;
  /// Sends a request; returns false if nobody offers the service.
  bool call(const std::string & name, const std::string & type, Packet request, Respond respond);

  bool matches(const Publication & publication, const Subscribed & subscribed) const;
  std::size_t publishers_for(const Subscribed & subscribed) const;
  std::size_t subscribers_for(const Publication & publication) const;

  std::vector<std::shared_ptr<Publication>> publications;
  std::vector<std::shared_ptr<Subscribed>> subscriptions;
  std::vector<std::shared_ptr<Server>> servers;
  std::vector<std::shared_ptr<Calling>> clients;
  std::vector<std::string> nodes;
  bool closed = false;
  /// Counts changes; those who wait for one wait for this address.
  std::uint64_t changes = 0;

  // For the report.
  struct Use
  {
    bool sent = false, listened = false, asked = false, received = false;
  };
  std::map<std::string, Use> uses;
  std::vector<std::string> incompatibilities;
  std::vector<std::string> different_types;

  void changed();

private:
  bool match(Publication & publication, Subscribed & subscribed);
  void note(
    const Publication & publication, const Subscribed & subscribed, const std::string & what,
    std::vector<std::string> & notes);
  void deliver(Packet packet, Subscribed & subscribed);

  std::int64_t numbers_ = 0;
  std::uint64_t ids_ = 0;
};

/// What executors and others wait for: something may be ready.
void work_appeared();
const void * work();

/// What nothing looked at.
class Unobserved
{
public:
  static Unobserved & get();

  std::map<std::string, int> callbacks;
  std::map<std::string, bool> overrides;
  std::vector<std::string> warnings;

  void warn(const std::string & text);
};

}  // namespace sitaf_ros
