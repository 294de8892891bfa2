#include "core/topics.hh"

#include <google/protobuf/message.h>
#include <pybind11/stl.h>

#include <chrono>
#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/errors.hh"
#include "core/message_dict.hh"

namespace pongsim::python {

namespace {

/// @return The message type of a topic, from its publishers and subscribers in this simulation.
std::string typeOfTopic(Life& life, const std::string& topic) {
  const std::string whole = topic.starts_with('/') ? topic : "/" + topic;
  std::vector<std::string> types;
  std::vector<OwnTopic> topics = life.use().transport().node().ownTopics();
  for (const OwnTopic& each : topics) {
    if (each.name == whole && each.type != "*") types.push_back(each.type);
  }
  if (types.size() == 1) return types.front();
  throw py::value_error(
      types.empty() ? "this simulation has no topic '" + whole + "', so its type is unknown; give it as type=\"Twist\""
                    : "the topic '" + whole + "' has several types; give one as type=\"" + types.front() + "\"");
}

/// Raises ValueError if a topic has other types, so that nobody would get a message of this one.
void checkTypeOfTopic(Life& life, const std::string& topic, const std::string& type) {
  const std::string whole = topic.starts_with('/') ? topic : "/" + topic;
  std::string other;
  for (const OwnTopic& each : life.use().transport().node().ownTopics()) {
    if (each.name != whole) continue;
    if (each.type == type || each.type == "*") return;
    other = each.type;
  }
  if (other.empty()) return;
  throw py::value_error("the topic '" + whole + "' has the type " + other + ", not " + type);
}

/// Raises TypeError unless it says how messages are wanted, and ValueError for a class that the topic's are not of.
void checkWanted(Life& life, const std::string& topic, py::handle type) {
  if (type.is_none() || type.ptr() == reinterpret_cast<PyObject*>(&PyBytes_Type)) return;
  const std::string name = PyType_Check(type.ptr()) ? typeOfObject(type) : std::string();
  if (name.empty()) {
    throw py::type_error("type must be None, bytes or a message class such as pongsim.messages.Twist, not " +
                         py::repr(type).cast<std::string>());
  }
  checkTypeOfTopic(life, topic, knownType(name));
}

std::chrono::nanoseconds nanoseconds(double seconds) {
  if (!std::isfinite(seconds) || seconds < 0 || seconds > 1e6) {
    throw py::value_error("a timeout must be 0 to 1e6 s, not " + std::to_string(seconds));
  }
  return std::chrono::nanoseconds(static_cast<std::int64_t>(seconds * 1e9));
}

/// @return The response of a service of this simulation, or nothing if there is none with these types.
std::optional<CallResult> requestHere(Life& life, const std::string& service, const Message& request, Message& reply) {
  Transport& transport = life.edit("a request").transport();
  std::optional<CallResult> result;
  const std::string type = reply.GetTypeName();
  PendingRequest pending =
      transport.node().request(service, request, type, [&](const CallResult& outcome, const Message& answer) {
        result = outcome;
        if (outcome) reply.CopyFrom(answer);
      });
  if (!pending) return std::nullopt;
  life.stepping([&] { transport.dispatch(); });
  if (!result) result = CallResult{CallOutcome::kNoAnswer, "service '" + service + "' did not answer"};
  return result;
}

}  // namespace

std::shared_ptr<PythonSubscription> PythonSubscription::open(const std::shared_ptr<Life>& life,
                                                             const std::string& topic, py::object callback,
                                                             py::object type, std::size_t length) {
  Simulation& simulation = life->use();
  if (length == 0) throw py::value_error("the length must be above 0");
  checkWanted(*life, topic, type);
  auto subscription = std::make_shared<PythonSubscription>();
  subscription->topic_ = topic;
  subscription->life_ = life;
  subscription->callback_ = life->keep(std::move(callback));
  subscription->type_ = life->keep(std::move(type));
  PythonSubscription* raw = subscription.get();
  Life* owner = life.get();
  subscription->subscription_ = simulation.transport().node().subscribeAnyType(
      topic,
      [raw, owner](std::string_view name, std::span<const std::byte> bytes) { raw->receive(*owner, name, bytes); },
      {.queueLength = length});
  life->hold(subscription);
  return subscription;
}

void PythonSubscription::close() {
  letGo();
  if (const auto life = life_.lock()) life->drop(*this);
}

void PythonSubscription::letGo() {
  end(subscription_);
  callback_.reset();
  type_.reset();
}

void PythonSubscription::receive(Life& life, std::string_view name, std::span<const std::byte> bytes) {
  const interpreter::Held gil;
  if (!callback_) return;
  try {
    const py::object callback = callback_->get();
    callback(messageAs(type_->get(), std::string(name), bytes));
  } catch (py::error_already_set& error) {
    life.noteError(error);
  } catch (const py::builtin_exception& wrong) {
    wrong.set_error();
    py::error_already_set error;
    life.noteError(error);
  }
}

std::string typeFor(Life& life, const std::string& topic, const std::string& type) {
  return type.empty() ? typeOfTopic(life, topic) : knownType(type);
}

void publish(Life& life, const std::string& topic, py::handle message, const std::string& type) {
  Node node = life.use().transport().node();
  const std::string name = typeFor(life, topic, type.empty() ? typeOfObject(message) : type);
  const MessagePointer filled = newMessage(name);
  fillIn(*filled, message);
  Publisher& publisher = life.publishers[{topic, name}];
  if (!publisher) {
    checkTypeOfTopic(life, topic, name);
    publisher = node.advertise(topic, name);
  }
  if (const std::optional<std::string> reason = node.refusal(topic, *filled)) {
    throw py::value_error("the message on '" + topic + "' is refused: " + *reason);
  }
  publisher.publish(*filled);
}

void checkMessage(Life& life, const std::string& topic, py::handle message, const std::string& type) {
  const std::string name = typeFor(life, topic, type.empty() ? typeOfObject(message) : type);
  const MessagePointer filled = newMessage(name);
  fillIn(*filled, message);
  checkTypeOfTopic(life, topic, name);
  if (const std::optional<std::string> reason = life.use().transport().node().refusal(topic, *filled)) {
    throw py::value_error("the message on '" + topic + "' is refused: " + *reason);
  }
}

py::object request(const std::shared_ptr<Life>& life, const std::string& service, py::handle message,
                   const std::string& requestType, py::handle replyType, double timeout) {
  const std::chrono::nanoseconds limit = nanoseconds(timeout);
  std::string requestName = requestType.empty() ? typeOfObject(message) : requestType;
  if (requestName.empty()) {
    throw py::value_error("the type of the request is unknown; give it as type=\"Entity\", or use a message class");
  }
  const bool isNamed = PyUnicode_Check(replyType.ptr());
  const std::string replyName = knownType(isNamed ? replyType.cast<std::string>()
                                                  : replyType.attr("DESCRIPTOR").attr("full_name").cast<std::string>());
  const MessagePointer filled = newMessage(knownType(requestName));
  const MessagePointer reply = newMessage(replyName);
  fillIn(*filled, message);

  std::optional<CallResult> result = requestHere(*life, service, *filled, *reply);
  if (!result && life->isOnNetwork()) {
    Node node = life->use().transport().node();
    life->stepping([&] { result = node.call(service, *filled, *reply, limit); });
  }
  if (!result) {
    raise("ServiceError", "this simulation has no service '" + service + "' that takes " + filled->GetTypeName() +
                              " and answers with " + replyName +
                              (life->isOnNetwork() ? "" : "; to call services of other processes, use network=True"));
  }
  if (!*result) raise("ServiceError", result->error);
  const std::string bytes = reply->SerializeAsString();
  return messageAs(isNamed ? py::handle(Py_None) : replyType, replyName, std::as_bytes(std::span(bytes)));
}

void bindTopics(py::module_& module) {
  py::class_<PythonSubscription, std::shared_ptr<PythonSubscription>>(
      module, "Subscription", "A subscription to a topic, until `close` or the end of the simulation.")
      .def("close", &PythonSubscription::close, "Ends the subscription.")
      .def_property_readonly("topic", &PythonSubscription::topic, "The topic's name as given.")
      .def_property_readonly("is_open", &PythonSubscription::isOpen, "Whether it is active.")
      .def_property_readonly("received", &PythonSubscription::received, "Messages received so far.")
      .def_property_readonly("dropped", &PythonSubscription::dropped,
                             "Messages dropped so far because more than `length` arrived between two steps.");
  module.def("message_types", &messageTypes, "The full names of all message types, sorted.");
  module.def("message_type", &knownType, py::arg("name"),
             "The full name of a message type: \"ignition.msgs.Twist\" for \"Twist\" or "
             "\"gz.msgs.Twist\". Raises ValueError if there is none.");
  module.def("message_files", &filesOf, py::arg("type"),
             "The file that describes a message type and its imports, as FileDescriptorProto in binary form, each "
             "after its own imports.");
}

}  // namespace pongsim::python
