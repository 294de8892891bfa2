#include "urdf/urdfdom.hh"

#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "urdf/xml_text.hh"

namespace pongsim::urdf {

namespace {

struct Remark {
  std::string text;
  bool isError;
  bool operator==(const Remark&) const = default;
};

/// Captures urdfdom's console output during its lifetime. The process has one console, so only one listener exists at a
/// time.
class ConsoleListener : private console_bridge::OutputHandler {
 public:
  ConsoleListener() : lock_(mutex()), level_(console_bridge::getLogLevel()) {
    console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_WARN);
    console_bridge::useOutputHandler(this);
  }
  ~ConsoleListener() override {
    console_bridge::restorePreviousOutputHandler();
    console_bridge::setLogLevel(level_);
  }
  ConsoleListener(const ConsoleListener&) = delete;
  ConsoleListener& operator=(const ConsoleListener&) = delete;

  const std::vector<Remark>& remarks() const { return remarks_; }

 private:
  static std::mutex& mutex() {
    static std::mutex one;
    return one;
  }
  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    // it reports some things twice
    const Remark remark{text, level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR};
    if (std::ranges::find(remarks_, remark) == remarks_.end()) remarks_.push_back(remark);
  }

  std::scoped_lock<std::mutex> lock_;
  console_bridge::LogLevel level_;
  std::vector<Remark> remarks_;
};

/// @return Position of the part named in the text, as in "Could not parse visual element for Link [arm]"; else that of
/// the robot.
const SourcePosition& placeOf(const std::string& text, const Element& robot) {
  for (const Element& part : robot.children) {
    if (part.name != "link" && part.name != "joint") continue;
    const std::string name = part.attributeOr("name", "");
    if (text.find('[' + name + ']') != std::string::npos || text.find('\'' + name + '\'') != std::string::npos) {
      return part.position;
    }
  }
  return robot.position;
}

}  // namespace

::urdf::ModelInterfaceSharedPtr readWithUrdfdom(const Element& robot, Diagnostics& diagnostics) {
  ::urdf::ModelInterfaceSharedPtr model;
  std::vector<Remark> remarks;
  {
    const ConsoleListener listener;
    model = ::urdf::parseURDF(xmlOf(robot));
    remarks = listener.remarks();
  }
  bool isSound = model != nullptr;
  for (const Remark& remark : remarks) {
    const SourcePosition& place = placeOf(remark.text, robot);
    if (remark.isError) {
      diagnostics.error(place, "urdfdom: " + remark.text);
      // it may still continue, without the faulty part
      isSound = false;
    } else {
      diagnostics.warning(place, "urdfdom: " + remark.text);
    }
  }
  if (model == nullptr && !diagnostics.hasErrors()) diagnostics.error(robot.position, "urdfdom can't parse this robot");
  return isSound ? model : nullptr;
}

}  // namespace pongsim::urdf
