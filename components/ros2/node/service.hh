#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "ros2/node/node.hh"

namespace pongsim::ros2 {

/// A ROS service is a struct with its name and two structs:
///
///     struct ControlWorld {
///       static constexpr const char* kName = "ros_gz_interfaces/srv/ControlWorld";
///       struct Request { static constexpr const char* kName = "ros_gz_interfaces/srv/ControlWorld_Request"; ... };
///       struct Response { static constexpr const char* kName = "ros_gz_interfaces/srv/ControlWorld_Response"; ... };
///     };
///
/// Where an older version of it has another request or response, it has the type, `OlderRequest` or `OlderResponse`,
/// and a conversion, `fromOlder` or `toOlder`; where a newer one has another response, `NewerResponse` and `toNewer`.
/// Clients of all are served: they announce the hashes of their types, and those that don't are taken for what
/// `RosNode::Options` says.
template <class Type>
concept ServiceType = Structure<typename Type::Request> && Structure<typename Type::Response>;

namespace detail {

/// Who gets a reply.
struct Caller {
  /// The reader of the reply where the client names it, as with rmw_fastrtps, else the writer of the request; and the
  /// request's number.
  SampleId id;
  /// What rmw_cyclonedds puts in front of its request and expects in front of the reply; otherwise empty.
  std::vector<std::byte> header = {};
};

struct Reply {
  std::vector<std::byte> payload;
  /// For clients of an older or newer version; empty: it is the same.
  std::vector<std::byte> older = {};
  std::vector<std::byte> newer = {};
};

/// The endpoints of a service on the wire, for any types.
class ServerEnds {
 public:
  struct Types {
    TypeInfo request;
    TypeInfo response;
    /// Of the older and newer versions; the same if there is none.
    TypeInfo olderRequest = request;
    TypeInfo olderResponse = response;
    TypeInfo newerResponse = response;
  };
  /// @param received Called from a DDS thread with each request.
  ServerEnds(RosNode& node, const std::string& service, const Types& types, Reader::Received received);
  /// Waits until replies have reached their clients: up to 5 s for the discovery of one, and 1 s for all.
  ~ServerEnds();
  ServerEnds(const ServerEnds&) = delete;
  ServerEnds& operator=(const ServerEnds&) = delete;

  const std::string& service() const { return service_; }
  /// Sends a reply, to the caller alone. If the caller's reader has not been discovered yet, waits a while for it,
  /// because the reply would be lost.
  void reply(const Caller& caller, Reply reply);

 private:
  struct Waiting {
    Caller caller;
    Reply reply;
    std::chrono::steady_clock::time_point until;
  };
  void readersChanged();
  bool isFor(const Guid& reader, const SampleId& caller) const;
  bool send(const Waiting& reply);
  const std::vector<std::byte>& payloadFor(const std::string& hash, const Reply& reply) const;

  RosNode& node_;
  std::string service_;
  Types types_;
  std::string replyTopic_;
  std::mutex mutex_;
  std::condition_variable sent_;
  std::deque<Waiting> waiting_;
  std::unique_ptr<Writer> writer_;
  std::unique_ptr<Reader> reader_;
};

}  // namespace detail

/// A request that is answered once, now or later, from any thread. If it is destroyed, it is never answered.
template <ServiceType Service>
class Responder {
 public:
  Responder(std::weak_ptr<detail::ServerEnds> ends, detail::Caller caller)
      : ends_(std::move(ends)), caller_(std::move(caller)) {}

  /// Does nothing if the service has ended.
  void answer(const typename Service::Response& response) const {
    const auto ends = ends_.lock();
    if (!ends) return;
    detail::Reply reply{toCdr(response)};
    if constexpr (requires { Service::toOlder(response); }) reply.older = toCdr(Service::toOlder(response));
    if constexpr (requires { Service::toNewer(response); }) reply.newer = toCdr(Service::toNewer(response));
    ends->reply(caller_, std::move(reply));
  }

 private:
  std::weak_ptr<detail::ServerEnds> ends_;
  detail::Caller caller_;
};

/// A service offered for the lifetime of this object.
class RosServer {
 public:
  explicit RosServer(std::shared_ptr<detail::ServerEnds> ends) : ends_(std::move(ends)) {}
  const std::string& name() const { return ends_->service(); }

 private:
  std::shared_ptr<detail::ServerEnds> ends_;
};

namespace detail {

/// Calls the handler with a request that has been read, and the client to answer.
using Handling = std::function<void(const std::weak_ptr<ServerEnds>& ends, const Caller& caller)>;
/// Reads a request.
/// @param isOlder Whether it is of the older version of the type.
/// @return The call of its handler; empty, with the reason in `error`, if the payload is invalid.
using ReadRequest = std::function<Handling(std::span<const std::byte> payload, bool isOlder, std::string& error)>;

template <ServiceType Service>
ServerEnds::Types typesOf() {
  ServerEnds::Types types{typeInfo<typename Service::Request>(), typeInfo<typename Service::Response>()};
  if constexpr (requires { typename Service::OlderRequest; }) {
    types.olderRequest = typeInfo<typename Service::OlderRequest>();
  }
  if constexpr (requires { typename Service::OlderResponse; }) {
    types.olderResponse = typeInfo<typename Service::OlderResponse>();
  }
  if constexpr (requires { typename Service::NewerResponse; }) {
    types.newerResponse = typeInfo<typename Service::NewerResponse>();
  }
  return types;
}

template <ServiceType Service>
std::optional<std::string> readRequest(std::span<const std::byte> payload, bool isOlder,
                                       typename Service::Request& request) {
  if constexpr (requires { typename Service::OlderRequest; }) {
    if (isOlder) {
      typename Service::OlderRequest older;
      auto wrong = readCdr(payload, older);
      if (!wrong) request = Service::fromOlder(older);
      return wrong;
    }
  }
  return readCdr(payload, request);
}
/// Offers a service, for any types.
std::unique_ptr<RosServer> serve(RosNode& node, const std::string& service, const ServerEnds::Types& types,
                                 ReadRequest read);

}  // namespace detail

/// Offers a service.
/// @param handler Called from `RosNode::mailbox().dispatch()` with each request and the object for answering it.
/// @throws std::invalid_argument for a bad name.
template <ServiceType Service>
std::unique_ptr<RosServer> serve(
    RosNode& node, const std::string& service,
    std::function<void(const typename Service::Request&, const Responder<Service>&)> handler) {
  using Request = typename Service::Request;
  return detail::serve(node, service, detail::typesOf<Service>(),
                       [shared = std::make_shared<decltype(handler)>(std::move(handler))](
                           std::span<const std::byte> payload, bool isOlder, std::string& error) -> detail::Handling {
                         const auto request = std::make_shared<Request>();
                         if (auto wrong = detail::readRequest<Service>(payload, isOlder, *request)) {
                           error = std::move(*wrong);
                           return {};
                         }
                         return [shared, request](const std::weak_ptr<detail::ServerEnds>& ends,
                                                  const detail::Caller& caller) {
                           (*shared)(*request, Responder<Service>(ends, caller));
                         };
                       });
}

/// As above, for a handler that answers immediately.
template <ServiceType Service>
std::unique_ptr<RosServer> serveAtOnce(
    RosNode& node, const std::string& service,
    std::function<typename Service::Response(const typename Service::Request&)> handler) {
  return serve<Service>(
      node, service,
      [handler = std::move(handler)](const typename Service::Request& request, const Responder<Service>& responder) {
        responder.answer(handler(request));
      });
}

namespace detail {

/// The endpoints of a client, for any types.
class ClientEnds {
 public:
  ClientEnds(RosNode& node, const std::string& service, const ServerEnds::Types& types);
  ~ClientEnds();
  ClientEnds(const ClientEnds&) = delete;
  ClientEnds& operator=(const ClientEnds&) = delete;

  /// Waits for the server, then for its answer.
  std::optional<std::vector<std::byte>> call(const std::vector<std::byte>& request, std::chrono::nanoseconds timeout);

 private:
  void received(const Sample& sample);
  bool servesCyclone() const;
  std::vector<std::byte> cycloneHeader() const;

  RosNode& node_;
  std::string requestTopic_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::int64_t nextNumber_ = 1;
  std::int64_t awaited_ = 0;
  /// Whether the awaited reply begins with rmw_cyclonedds's header.
  bool awaitsHeader_ = false;
  std::optional<std::vector<std::byte>> answer_;
  std::unique_ptr<Reader> reader_;
  std::unique_ptr<Writer> writer_;
};

}  // namespace detail

/// Calls a service. For one thread at a time, which must not be the one on which a server in this process answers.
template <ServiceType Service>
class RosClient {
 public:
  RosClient(RosNode& node, const std::string& service)
      : ends_(node, service, {typeInfo<typename Service::Request>(), typeInfo<typename Service::Response>()}) {}

  /// @param timeout For finding the service and for the answer.
  /// @return The answer; nothing if none arrived in time.
  std::optional<typename Service::Response> call(const typename Service::Request& request,
                                                 std::chrono::nanoseconds timeout) {
    const auto payload = ends_.call(toCdr(request), timeout);
    typename Service::Response response;
    if (!payload || readCdr(*payload, response)) return std::nullopt;
    return response;
  }

 private:
  detail::ClientEnds ends_;
};

}  // namespace pongsim::ros2
