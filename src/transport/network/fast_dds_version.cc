#include "transport/network/fast_dds_version.hh"

#include <fastrtps/config.h>

namespace pongsim::transport {

std::string fastDdsVersion() { return FASTRTPS_VERSION_STR; }

}  // namespace pongsim::transport
