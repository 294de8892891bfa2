// Arbitrary bytes as a message's text: the parser must end, and what it accepts must print as text that it accepts.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "pongsim/message.hh"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  for (const char* type : {"Twist", "Pose_V", "WorldControl"}) {
    const pongsim::MessagePointer message = pongsim::newMessage(type);
    if (pongsim::parseMessage(text, *message)) continue;
    if (pongsim::parseMessage(pongsim::messageText(*message), *message)) std::abort();
  }
  return 0;
}
