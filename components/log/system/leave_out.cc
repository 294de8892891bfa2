#include "log/system/leave_out.hh"

#include "pongsim/parameters.hh"

namespace pongsim::log {

void leaveOut(const SystemContext& context, const std::string& why, const std::string& hint) {
  // what a program adds has no line in a file
  if (context.sdf.position.line > 0) refuse(context.sdf, why, hint);
  context.diagnostics.error(context.sdf.position, why, hint);
}

}  // namespace pongsim::log
