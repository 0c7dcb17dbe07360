// What the test driver calls. All functions are for the thread of the driver, which is no thread of the node.
#include <cstring>
#include <map>
#include <memory>
#include <string>

#include "case.hpp"
#include "kernel.hpp"
#include "sitaf_ros/entry.hpp"
#include "terminal.hpp"

using sitaf_ros::Case;
using sitaf_ros::Event;
using sitaf_ros::EventKind;
using sitaf_ros::Graph;
using sitaf_ros::Nanos;
using sitaf_ros::Packet;
using sitaf_ros::Quality;
namespace kernel = sitaf_ros::kernel;

namespace {

// The test's publishers and subscriptions.
struct Test : sitaf_ros::Endpoint
{
  std::int64_t id = 0;
  void receive(const Packet & packet) override
  {
    Packet copy = packet;
    Case::get().events.push_back(
      {EventKind::MESSAGE, id, packet.number, packet.time, "", copy.serialized()});
  }
};

Test publishing;
std::map<std::int64_t, std::shared_ptr<sitaf_ros::Publication>> publications;
std::vector<std::unique_ptr<Test>> subscriptions;
std::map<std::int64_t, sitaf_ros::Respond> open_requests;
std::int64_t count = 0;
Event taken{EventKind::MESSAGE};
std::string text;

Packet packet_of(const std::uint8_t * data, std::size_t size)
{
  Packet packet;
  packet.bytes = std::make_shared<const sitaf_ros::Bytes>(data, data + size);
  return packet;
}

}  // namespace

extern "C" {

struct SitafEvent
{
  std::int32_t kind;
  std::int64_t id, number, time;
  const char * text;
  std::size_t text_size;
  const std::uint8_t * bytes;
  std::size_t bytes_size;
};

int sitaf_ros_version() {return 1;}

void sitaf_ros_set(const char * what, const char * name, const char * value)
{
  const std::string kind = what;
  Case & settings = Case::get();
  if (kind == "remap") {
    settings.remap.emplace_back(name, value);
  } else if (kind == "callback_order") {
    settings.callback_order = std::stoll(value);
  } else if (kind == "use_sim_time") {
    settings.use_sim_time = std::string(value) == "1";
  } else if (kind == "stdin") {
    sitaf_ros::add_input(value);
  }
}

/// Makes the main thread of the node ready.
void sitaf_ros_begin()
{
  sitaf_ros::begin_input();
  kernel::running("main");
  kernel::start("main", sitaf_ros::run_entry);
}
void sitaf_ros_run_ready() {kernel::run_ready();}
std::int64_t sitaf_ros_next_deadline() {return kernel::next_deadline();}
void sitaf_ros_set_now(std::int64_t time) {kernel::set_now(time);}
void sitaf_ros_advance(std::int64_t time) {kernel::advance_to(time);}
void sitaf_ros_end()
{
  Graph::get().closed = true;
  kernel::end();
}

/// Takes the next event; 0 if there is none. What it points to is valid until the next call.
int sitaf_ros_take(SitafEvent * into)
{
  auto & events = Case::get().events;
  if (events.empty()) {
    return 0;
  }
  taken = std::move(events.front());
  events.pop_front();
  *into = {static_cast<std::int32_t>(taken.kind), taken.id, taken.number, taken.time, taken.text.data(),
    taken.text.size(), taken.bytes.data(), taken.bytes.size()};
  return 1;
}

void sitaf_ros_overrides(const std::uint8_t * data, std::size_t size)
{
  Case & settings = Case::get();
  settings.overrides.assign(data, data + size);
  settings.has_overrides = true;
  kernel::wake(&settings.has_overrides);
}

std::int64_t sitaf_ros_number() {return Graph::get().next_number();}

std::int64_t sitaf_ros_advertise(const char * topic, const char * type)
{
  // What every subscription accepts.
  Quality quality;
  quality.depth = 1;
  quality.transient_local = true;
  quality.deadline = 0;
  quality.manual_liveliness = true;
  quality.lease = 0;
  auto made = std::make_shared<sitaf_ros::Publication>(
    sitaf_ros::Publication{topic, type, quality, &publishing, ""});
  publications[++count] = made;
  Graph::get().add(made);
  return count;
}

void sitaf_ros_publish(std::int64_t id, const std::uint8_t * data, std::size_t size)
{
  Graph::get().publish(*publications.at(id), packet_of(data, size));
}

std::int64_t sitaf_ros_subscribe(const char * topic, const char * type)
{
  Quality quality;
  quality.keep_all = true;
  quality.reliable = false;
  auto endpoint = std::make_unique<Test>();
  endpoint->id = ++count;
  Graph::get().add(
    std::make_shared<sitaf_ros::Subscribed>(sitaf_ros::Subscribed{topic, type, quality, endpoint.get(), ""}));
  subscriptions.push_back(std::move(endpoint));
  return count;
}

std::int64_t sitaf_ros_serve(const char * name, const char * type)
{
  const std::int64_t id = ++count;
  Graph::get().add(
    std::make_shared<sitaf_ros::Server>(
      sitaf_ros::Server{name, type, [id](Packet request, sitaf_ros::Respond respond) {
          const std::int64_t number = request.number;
          open_requests[number] = std::move(respond);
          Case::get().events.push_back(
            {EventKind::REQUEST, id, number, request.time, "", request.serialized()});
        }, ""}));
  return id;
}

void sitaf_ros_respond(std::int64_t number, const std::uint8_t * data, std::size_t size)
{
  const auto found = open_requests.find(number);
  if (found != open_requests.end()) {
    const auto respond = std::move(found->second);
    open_requests.erase(found);
    respond(packet_of(data, size));
  }
}

/// Returns the number of the call, or 0 if no node offers the service.
std::int64_t sitaf_ros_call(const char * name, const char * type, const std::uint8_t * data, std::size_t size)
{
  const std::int64_t id = ++count;
  const bool sent = Graph::get().call(
    name, type, packet_of(data, size), [id](Packet response) {
      Case::get().events.push_back({EventKind::RESPONSE, id, response.number, response.time, "", response.serialized()});
    });
  return sent ? id : 0;
}

/// What the node does, or did when its process was ended by a signal. To be called once before the process is forked.
const char * sitaf_ros_running() {return kernel::running();}

/// The first failure of the node: its place, a tab and its text.
const char * sitaf_ros_failure() {return kernel::failure().c_str();}

/// Whether a node offers a service.
int sitaf_ros_offers(const char * name)
{
  for (const auto & server : Graph::get().servers) {
    if (server->name == name && !server->node.empty()) {
      return 1;
    }
  }
  return 0;
}

/// What the nodes did that nothing looked at: lines of a kind, a tab and a name.
const char * sitaf_ros_report()
{
  text.clear();
  const auto add = [](const std::string & kind, const std::string & name) {text += kind + "\t" + name + "\n";};
  const auto & unobserved = sitaf_ros::Unobserved::get();
  for (const auto & [name, declared] : unobserved.overrides) {
    if (!declared) {
      add("undeclared_parameters", name);
    }
  }
  for (const auto & [topic, use] : Graph::get().uses) {
    if (topic == "/parameter_events" || topic == "/rosout" || topic == "/clock" ||
      topic.find("/_action/") != std::string::npos)
    {
      continue;
    }
    if (use.sent && !use.listened) {
      add("unobserved_topics", topic);
    }
    if (use.asked && !use.received) {
      add("unfed_topics", topic);
    }
  }
  for (const auto & [name, times] : unobserved.callbacks) {
    if (times == 0) {
      add("uncalled_callbacks", name);
    }
  }
  for (const auto & one : Graph::get().different_types) {
    add("different_types", one);
  }
  for (const auto & one : Graph::get().incompatibilities) {
    add("incompatible_qos", one);
  }
  for (const auto & warning : unobserved.warnings) {
    add("warnings", warning);
  }
  if (kernel::looked_too_often()) {
    add("warnings", "a loop of the node never waits; each 500 looks at the clock or a queue count as 1 ms");
  }
  if (sitaf_ros::lacks_input()) {
    add("warnings", "the node waits for a line of standard input; stdin in activity.yaml can give it one");
  }
  if (kernel::called_back_too_often()) {
    add("warnings", "more than 20000 callbacks at one instant");
  }
  return text.c_str();
}

const char * sitaf_ros_nodes()
{
  text.clear();
  for (const auto & node : Graph::get().nodes) {
    text += node + "\n";
  }
  return text.c_str();
}

}  // extern "C"
