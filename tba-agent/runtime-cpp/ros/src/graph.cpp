#include "sitaf_ros/graph.hpp"

#include <algorithm>

namespace sitaf_ros {

namespace {

const char work_ = 0;

template<class T>
bool take_out(std::vector<std::shared_ptr<T>> & from, const std::shared_ptr<T> & item)
{
  const auto found = std::find(from.begin(), from.end(), item);
  if (found == from.end()) {
    return false;
  }
  from.erase(found);
  return true;
}

const std::string & shown(const std::string & node)
{
  static const std::string test = "the test";
  return node.empty() ? test : node;
}

}  // namespace

void work_appeared() {kernel::wake(&work_);}
const void * work() {return &work_;}

const char * incompatible(const Quality & offered, const Quality & requested)
{
  if (requested.reliable && !offered.reliable) {
    return "RELIABILITY";
  }
  if (requested.transient_local && !offered.transient_local) {
    return "DURABILITY";
  }
  if (offered.deadline > requested.deadline) {
    return "DEADLINE";
  }
  if ((requested.manual_liveliness && !offered.manual_liveliness) || offered.lease > requested.lease) {
    return "LIVELINESS";
  }
  return nullptr;
}

const Bytes & Packet::serialized()
{
  if (bytes == nullptr) {
    auto written = std::make_shared<Bytes>();
    type->write(message.get(), *written);
    bytes = written;
  }
  return *bytes;
}

Graph & Graph::get()
{
  static Graph graph;
  return graph;
}

Unobserved & Unobserved::get()
{
  static Unobserved unobserved;
  return unobserved;
}

void Unobserved::warn(const std::string & text)
{
  if (std::find(warnings.begin(), warnings.end(), text) == warnings.end()) {
    warnings.push_back(text);
  }
}

void Graph::changed()
{
  ++changes;
  kernel::wake(&changes);
  work_appeared();
}

bool Graph::matches(const Publication & publication, const Subscribed & subscribed) const
{
  return publication.topic == subscribed.topic && publication.type == subscribed.type &&
         incompatible(publication.quality, subscribed.quality) == nullptr;
}

std::size_t Graph::publishers_for(const Subscribed & subscribed) const
{
  return std::count_if(
    publications.begin(), publications.end(), [&](const auto & p) {return matches(*p, subscribed);});
}

std::size_t Graph::subscribers_for(const Publication & publication) const
{
  return std::count_if(
    subscriptions.begin(), subscriptions.end(), [&](const auto & s) {return matches(publication, *s);});
}

void Graph::note(
  const Publication & publication, const Subscribed & subscribed, const std::string & what,
  std::vector<std::string> & notes)
{
  const std::string text = publication.topic + ": " + shown(publication.node) + " -> " + shown(subscribed.node) +
    ": " + what;
  if (std::find(notes.begin(), notes.end(), text) == notes.end()) {
    notes.push_back(text);
  }
}

bool Graph::match(Publication & publication, Subscribed & subscribed)
{
  if (publication.topic != subscribed.topic) {
    return false;
  }
  if (publication.type != subscribed.type) {
    note(publication, subscribed, publication.type + " and " + subscribed.type, different_types);
    return false;
  }
  if (const char * policy = incompatible(publication.quality, subscribed.quality)) {
    note(publication, subscribed, policy, incompatibilities);
    publication.owner->incompatible_with(policy);
    subscribed.owner->incompatible_with(policy);
    return false;
  }
  publication.owner->matched(1);
  subscribed.owner->matched(1);
  return true;
}

void Graph::add(const std::shared_ptr<Publication> & publication)
{
  publication->id = ++ids_;
  publications.push_back(publication);
  for (const auto & subscribed : std::vector(subscriptions)) {
    match(*publication, *subscribed);
  }
  changed();
}

void Graph::remove(const std::shared_ptr<Publication> & publication)
{
  if (take_out(publications, publication)) {
    for (const auto & subscribed : std::vector(subscriptions)) {
      if (matches(*publication, *subscribed)) {
        subscribed->owner->matched(-1);
      }
    }
    changed();
  }
}

void Graph::add(const std::shared_ptr<Subscribed> & subscribed)
{
  subscriptions.push_back(subscribed);
  auto & use = uses[subscribed->topic];
  use.listened = true;
  use.asked |= !subscribed->node.empty();
  for (const auto & publication : std::vector(publications)) {
    if (match(*publication, *subscribed) && subscribed->quality.transient_local) {
      for (const Packet & packet : publication->kept) {
        if (kernel::now() - packet.time <= publication->quality.lifespan) {
          deliver(packet, *subscribed);
        }
      }
    }
  }
  changed();
}

void Graph::remove(const std::shared_ptr<Subscribed> & subscribed)
{
  if (take_out(subscriptions, subscribed)) {
    for (const auto & publication : std::vector(publications)) {
      if (matches(*publication, *subscribed)) {
        publication->owner->matched(-1);
      }
    }
    changed();
  }
}

void Graph::alive(const Publication & publication, int change)
{
  for (const auto & subscribed : std::vector(subscriptions)) {
    if (matches(publication, *subscribed)) {
      subscribed->owner->alive(change);
    }
  }
}

void Graph::publish(Publication & publication, Packet packet)
{
  if (closed) {
    return;
  }
  packet.number = next_number();
  packet.time = kernel::now();
  packet.publisher = publication.id;
  ++publication.sent;
  if (!publication.node.empty()) {
    uses[publication.topic].sent = true;
  }
  if (publication.quality.transient_local) {
    publication.kept.push_back(packet);
    if (!publication.quality.keep_all && publication.kept.size() > std::max<std::size_t>(1, publication.quality.depth)) {
      publication.kept.pop_front();
    }
  }
  for (const auto & subscribed : std::vector(subscriptions)) {
    if (matches(publication, *subscribed)) {
      deliver(packet, *subscribed);
    }
  }
  work_appeared();
}

void Graph::deliver(Packet packet, Subscribed & subscribed)
{
  ++subscribed.received;
  if (!subscribed.node.empty()) {
    uses[subscribed.topic].received = true;
  }
  subscribed.owner->receive(packet);
}

void Graph::add(const std::shared_ptr<Server> & server)
{
  servers.push_back(server);
  changed();
}

void Graph::remove(const std::shared_ptr<Server> & server)
{
  if (take_out(servers, server)) {
    changed();
  }
}

void Graph::add(const std::shared_ptr<Calling> & calling)
{
  clients.push_back(calling);
  changed();
}

void Graph::remove(const std::shared_ptr<Calling> & calling)
{
  if (take_out(clients, calling)) {
    changed();
  }
}

std::shared_ptr<Server> Graph::server(const std::string & name, const std::string & type) const
{
  for (const auto & server : servers) {
    if (server->name == name && server->type == type) {
      return server;
    }
  }
  return nullptr;
}

bool Graph::call(const std::string & name, const std::string & type, Packet request, Respond respond)
{
  const auto found = server(name, type);
  if (found == nullptr || closed) {
    return false;
  }
  request.number = next_number();
  request.time = kernel::now();
  found->ask(
    std::move(request), [this, respond = std::move(respond)](Packet response) {
      if (!closed) {
        response.number = next_number();
        response.time = kernel::now();
        respond(std::move(response));
        work_appeared();
      }
    });
  work_appeared();
  return true;
}

}  // namespace sitaf_ros
