#include "ign/library.hh"

#include <functional>

// Members of this class belong to the library: they must not be instantiated here a second time with hidden visibility.
#pragma GCC visibility push(default)
#include <ignition/transport/Discovery.hh>
extern template class ignition::transport::Discovery<ignition::transport::MessagePublisher>;
#pragma GCC visibility pop

namespace pongsim::ign {

namespace {

using ignition::transport::MessagePublisher;
using ignition::transport::NodeShared;
using Discovery = ignition::transport::Discovery<MessagePublisher>;

/// Defines `memberOf` as that member of the class. An explicit instantiation may access private members.
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

/// The library's discovery threads run until the process ends. For each packet they copy two functions that are static
/// members of their class, which `exit` has destroyed by then, with their heap memory. Functions that hold only a
/// pointer can be copied and called after that.
///
/// The threads run already, and copy under the mutex of their `Discovery`: a packet within the nanoseconds of the two
/// assignments below could meet half of one. That can't be mended from outside the library. Only `NodeSharedPrivate`
/// has that object, whose header is not installed; the constructor of `NodeShared` sets the functions and starts the
/// threads. The public setters would need another `Discovery`, with sockets of its own, and lock its mutex instead.
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
