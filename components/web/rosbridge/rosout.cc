#include "web/rosbridge/rosout.hh"

#include <chrono>
#include <cstdint>

#include "web/rosbridge/cdr_json.hh"
#include "web/rosbridge/ros_topics.hh"

namespace pongsim::web::rosbridge {

namespace {

// rcl_interfaces/msg/Log
constexpr int kWarn = 30;
constexpr int kError = 40;

}  // namespace

// without the type's constants
const std::string_view kRosoutSchema = R"(builtin_interfaces/Time stamp
uint8 level
string name
string msg
string file
string function
uint32 line
================================================================================
MSG: builtin_interfaces/Time
int32 sec
uint32 nanosec
)";

const RosDefinition& rosoutDefinition() {
  static const RosDefinition definition = readDefinition(kRosoutSchema).value();
  return definition;
}

std::string rosoutMessage(const RecentLog::Line& line) {
  const auto ns = static_cast<std::uint64_t>(
      std::chrono::duration_cast<std::chrono::nanoseconds>(line.time.time_since_epoch()).count());
  const nlohmann::json message = {{"stamp", {{"sec", ns / kNanoseconds}, {"nanosec", ns % kNanoseconds}}},
                                  {"level", line.level == LogLevel::kError ? kError : kWarn},
                                  {"name", line.speaker},
                                  {"msg", line.message}};
  return writeCdr(rosoutDefinition(), message).value.value();
}

}  // namespace pongsim::web::rosbridge
