#include "web/frames/contact_channel.hh"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

namespace pongsim::web {

namespace {

constexpr std::chrono::milliseconds kContactPeriod{50};

}  // namespace

struct ContactChannel::Viewer {
  std::shared_ptr<Client> client;
  std::uint64_t key = 0;
  std::function<std::string(std::uint64_t)> head;
  /// What it was sent last.
  Payload before;
};

ContactChannel::ContactChannel(const std::string& world, std::function<void()> wake)
    : topic_("/world/" + world + "/contacts"), wake_(std::move(wake)) {}

std::shared_ptr<void> ContactChannel::open(const std::shared_ptr<Client>& client, std::uint64_t key,
                                           std::function<std::string(std::uint64_t timeNs)> head) {
  auto viewer = std::make_shared<Viewer>(Viewer{client, key, std::move(head), {}});
  {
    const std::lock_guard lock(mutex_);
    viewers_.push_back(viewer);
    isWatched_ = true;
    if (wake_) wake_();
  }
  return {viewer.get(), [self = shared_from_this(), viewer](void*) {
            {
              const std::lock_guard lock(self->mutex_);
              std::erase(self->viewers_, viewer);
              self->isWatched_ = !self->viewers_.empty();
            }
            viewer->client->forget(viewer->key);
          }};
}

void ContactChannel::send(const World& world, const StepInfo& step) {
  const Clock::time_point now = Clock::now();
  if (now < next_) return;
  next_ = now + kContactPeriod;
  world.contacts(contacts_);
  const Payload payload = encodeContacts(contacts_);
  const std::lock_guard lock(mutex_);
  for (const auto& viewer : viewers_) {
    if (std::ranges::equal(payload.bytes(), viewer->before.bytes())) continue;
    viewer->before = payload;
    viewer->client->sendData(viewer->key, 1, {viewer->head(static_cast<std::uint64_t>(step.time.count())), payload});
  }
}

void ContactChannel::end() {
  const std::lock_guard lock(mutex_);
  wake_ = {};
}

Payload encodeContacts(const std::vector<Contact>& contacts) {
  const std::size_t count = std::min(contacts.size(), kMostContacts);
  Payload payload(kContactHead + count * kContactEntry);
  std::byte* place = payload.bytes().data();
  const auto number = static_cast<std::uint32_t>(count);
  std::memcpy(place, &number, sizeof number);
  place += kContactHead;
  for (std::size_t i = 0; i < count; ++i) {
    const Contact& contact = contacts[i];
    std::array<float, 10> values{};
    std::size_t next = 0;
    for (const Vector3& vector : {contact.position, contact.normal, contact.force}) {
      for (const double value : vector) values[next++] = static_cast<float>(value);
    }
    values[next] = static_cast<float>(contact.depth);
    static_assert(sizeof values == kContactEntry);
    std::memcpy(place, values.data(), sizeof values);
    place += kContactEntry;
  }
  return payload;
}

}  // namespace pongsim::web
