#pragma once

#include <vector>

#include "fault.hh"
#include "pongsim/handles.hh"
#include "pongsim/log.hh"
#include "pongsim/physical_properties.hh"
#include "pongsim/state/state_archive.hh"

namespace pongsim::faults {

/// A fault of a joint or of its child: it sticks, its motor weakens, or its
/// wheel slips.
class JointFault {
 public:
  JointFault(const World& world, const Joint& joint, const Fault& fault);

  /// Begins or ends it. @param now When the step begins.
  void update(Time now, const Logger& log);
  /// The world was reset, and with it what the fault has changed.
  void reset() { isOn_ = false; }
  void transfer(StateArchive& archive);

 private:
  void begin(const Logger& log);
  void end(const Logger& log);

  PhysicalProperties properties_;
  Joint joint_;
  const Fault fault_;
  bool isOn_ = false;
  /// What was there before, of each axis or collision: two numbers.
  std::vector<double> before_;
};

}  // namespace pongsim::faults
