#include "web/server/session.hh"

#include <cstring>

namespace pongsim::web {

Payload::Payload(std::string_view text) : Payload(text.size()) {
  if (!text.empty()) std::memcpy(bytes_.get(), text.data(), text.size());
}

}  // namespace pongsim::web
