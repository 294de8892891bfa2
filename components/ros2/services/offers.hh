#pragma once

#include <exception>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "ros2/node/service.hh"
#include "ros2/services/result.hh"

namespace pongsim::ros2 {

/// Offers services for the lifetime of this object. If a handler throws, its caller gets a failure, and the simulation
/// goes on.
class Offers {
 public:
  /// @param node Must outlive it.
  explicit Offers(RosNode& node) : node_(node) {}

  /// @param service Resolved by `RosNode`. A name that ROS does not allow is not offered, with a warning.
  template <ServiceType Service>
  void add(const std::string& service,
           std::function<void(const typename Service::Request&, const Responder<Service>&)> handler) {
    try {
      keep(serve<Service>(node_, service,
                          [handler = std::move(handler)](const typename Service::Request& request,
                                                         const Responder<Service>& responder) {
                            try {
                              handler(request, responder);
                            } catch (const std::exception& error) {
                              typename Service::Response response;
                              if constexpr (requires { response.result.error_message; }) {
                                response.result = failed(error.what());
                              }
                              responder.answer(response);
                            }
                          }));
    } catch (const std::invalid_argument& error) {
      node_.log().warning(std::string("not offered: ") + error.what());
    }
  }

  /// As above, for a handler that answers immediately.
  template <ServiceType Service>
  void addAtOnce(const std::string& service,
                 std::function<typename Service::Response(const typename Service::Request&)> handler) {
    add<Service>(service, [handler = std::move(handler)](const typename Service::Request& request,
                                                         const Responder<Service>& responder) {
      responder.answer(handler(request));
    });
  }

 private:
  void keep(std::shared_ptr<RosServer> server) { servers_.push_back(std::move(server)); }

  RosNode& node_;
  std::vector<std::shared_ptr<RosServer>> servers_;
};

}  // namespace pongsim::ros2
