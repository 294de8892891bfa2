#include "ign/library.hh"

#include <functional>

// Static members of this class are those of the library: an instantiation here, with hidden visibility, would duplicate
// them.
#pragma GCC visibility push(default)
#include <ignition/transport/Discovery.hh>
extern template class ignition::transport::Discovery<ignition::transport::MessagePublisher>;
#pragma GCC visibility pop

namespace pongsim::ign {

namespace {

using ignition::transport::MessagePublisher;
using ignition::transport::NodeShared;
using Discovery = ignition::transport::Discovery<MessagePublisher>;

/// Defines `memberOf(Name)` to return a pointer to a private member: an explicit instantiation may name one.
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

/// Replaces two functions of the library by equivalents that can be used after `exit`.
///
/// The library's discovery threads run until the process ends. For each packet they copy two `std::function`s that are
/// static members of their class, and that `exit` destroys, with their memory on the heap. Functions that hold only a
/// pointer store it in place, so their bytes stay valid.
///
/// A data race remains. The threads run already, and copy the functions under the mutex of their `Discovery`; a packet
/// in the nanoseconds of the two assignments below could copy a half-written function. That mutex can't be locked from
/// here: only `NodeSharedPrivate`, whose header is not installed, has the object, and the constructor of `NodeShared`
/// both sets the functions and starts the threads. The public setters belong to another `Discovery`, with its own
/// sockets and mutex.
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
