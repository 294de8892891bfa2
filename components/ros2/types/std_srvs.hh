#pragma once

#include "ros2/types/reflection.hh"

namespace pongsim::ros2::std_srvs::srv {

struct Empty {
  static constexpr const char* kName = "std_srvs/srv/Empty";
  struct Request {
    static constexpr const char* kName = "std_srvs/srv/Empty_Request";
    static void visit(auto&, auto&&) {}
    bool operator==(const Request&) const = default;
  };
  struct Response {
    static constexpr const char* kName = "std_srvs/srv/Empty_Response";
    static void visit(auto&, auto&&) {}
    bool operator==(const Response&) const = default;
  };
};

}  // namespace pongsim::ros2::std_srvs::srv
