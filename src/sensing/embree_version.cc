#include "sensing/embree_version.hh"

#include <stdexcept>

#include "sensing/embree.hh"

namespace pongsim::sensing {

std::string embreeVersion() {
  try {
    const DevicePointer device(embree().newDevice("threads=1"));
    const auto part = [&device](RTCDeviceProperty property) {
      return std::to_string(embree().getDeviceProperty(device.get(), property));
    };
    return part(RTC_DEVICE_PROPERTY_VERSION_MAJOR) + "." + part(RTC_DEVICE_PROPERTY_VERSION_MINOR) + "." +
           part(RTC_DEVICE_PROPERTY_VERSION_PATCH);
  } catch (const std::runtime_error&) {
    return "not installed";
  }
}

}  // namespace pongsim::sensing
