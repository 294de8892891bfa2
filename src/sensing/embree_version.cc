#include "sensing/embree_version.hh"

#include "sensing/embree.hh"

namespace pongsim::sensing {

std::string embreeVersion() {
  const DevicePointer device(rtcNewDevice("threads=1"));
  if (device == nullptr) return "that does not start";
  const auto part = [&device](RTCDeviceProperty property) {
    return std::to_string(rtcGetDeviceProperty(device.get(), property));
  };
  return part(RTC_DEVICE_PROPERTY_VERSION_MAJOR) + "." + part(RTC_DEVICE_PROPERTY_VERSION_MINOR) + "." +
         part(RTC_DEVICE_PROPERTY_VERSION_PATCH);
}

}  // namespace pongsim::sensing
