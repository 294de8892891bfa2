#include "pongsim/system.hh"

namespace pongsim {

System::~System() = default;

}  // namespace pongsim
