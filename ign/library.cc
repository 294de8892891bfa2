#include "ign/library.hh"

#include <functional>

// What is a member of this class is the library's own, and must not be made a second time here, where it would be
// hidden.
#pragma GCC visibility push(default)
#include <ignition/transport/Discovery.hh>
extern template class ignition::transport::Discovery<ignition::transport::MessagePublisher>;
#pragma GCC visibility pop

namespace pongsim::ign {

namespace {

using ignition::transport::MessagePublisher;
using ignition::transport::NodeShared;
using Discovery = ignition::transport::Discovery<MessagePublisher>;

/// Gives `memberOf` that member of the class. An explicit instantiation may name what is private.
template <class Name, auto kMember>
struct Opened {
  friend constexpr auto memberOf(Name) { return kMember; }
};
struct Registration {
  friend constexpr auto memberOf(Registration);
};
struct Unregistration {
  friend constexpr auto memberOf(Unregistration);
};
template struct Opened<Registration, &Discovery::registrationCb>;
template struct Opened<Unregistration, &Discovery::unregistrationCb>;

/// The threads of the library's discovery run until the process is gone, and copy, for each packet, two functions that
/// are static members of its class: `exit` has destroyed them by then, and with them what they hold on the heap.
/// Functions that hold a pointer and nothing on the heap can be copied and called after that, too.
void keepFunctionsThroughExit(NodeShared& shared) {
  NodeShared* const there = &shared;
  *memberOf(Registration()) = [there](const MessagePublisher& reader) { there->OnNewRegistration(reader); };
  *memberOf(Unregistration()) = [there](const MessagePublisher& reader) { there->OnEndRegistration(reader); };
}

}  // namespace

NodeShared& library() {
  static NodeShared* const shared = [] {
    NodeShared* const made = NodeShared::Instance();
    keepFunctionsThroughExit(*made);
    return made;
  }();
  return *shared;
}

}  // namespace pongsim::ign
