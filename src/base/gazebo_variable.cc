#include "pongsim/program/gazebo_variable.hh"

#include <cstdlib>

namespace pongsim {

std::string GazeboVariable::value() const {
  for (const char* const name : {fortress, later}) {
    const char* const text = std::getenv(name);
    if (text != nullptr && *text != '\0') return text;
  }
  return {};
}

}  // namespace pongsim
