#include "ros2/bridge/mismatches.hh"

#include <algorithm>
#include <utility>

#include "ros2/pairs/pairs.hh"

namespace pongsim::ros2 {

namespace {

/// @return The quality that a reader requests and a writer does not offer; null if there is none.
const char* missing(const Qos& writer, const Qos& reader) {
  if (reader.isReliable && !writer.isReliable) return "reliable";
  if (reader.isTransientLocal && !writer.isTransientLocal) return "transient local";
  return nullptr;
}

std::string typeOf(const Graph::Endpoint& endpoint) {
  const std::string name = rosTypeName(endpoint.contract.type);
  return name.empty() ? endpoint.contract.type : name;
}

}  // namespace

std::optional<std::string> mismatch(const Offer& offer, const Graph::Endpoint& theirs) {
  if (topicFromWire(theirs.contract.topic) != offer.ros) return std::nullopt;
  const bool theyWrite = theirs.role == Graph::Role::kWriter;
  const std::optional<Qos>& here = theyWrite ? offer.reader : offer.writer;
  if (!here) return std::nullopt;
  const std::string who =
      std::string("a node ") + (theyWrite ? "publishes '" : "subscribes to '") + offer.ros + "' as ";
  const std::string outcome = theyWrite ? "no messages arrive" : "it receives no messages";

  if (const std::string type = typeOf(theirs); type != offer.pair->ros) {
    std::string text = who + type + ", which is " + std::string(offer.pair->ros) + " here: " + outcome;
    if (const Pair* other = findPair(type, offer.pair->ignition)) {
      text += "; --ros2-topic '" + offer.ignition + "@" + std::string(other->ros) + "@" + other->ignition +
              "' bridges that type";
    }
    return text;
  }
  if (const char* quality = theyWrite ? missing(theirs.contract.qos, *here) : missing(*here, theirs.contract.qos)) {
    return theyWrite ? who + "not " + quality + ", but " + quality + " is required here: " + outcome
                     : who + quality + ", but it is published as not " + quality + ": " + outcome;
  }
  const char* promise = theirs.contract.hasDeadline     ? "deadline"
                        : theirs.contract.hasLiveliness ? "liveliness"
                                                        : nullptr;
  if (!theyWrite && promise != nullptr) {
    return "a node subscribes to '" + offer.ros + "' with a " + promise + ", but it is published without: " + outcome;
  }
  return std::nullopt;
}

void Mismatches::update(std::uint64_t offersVersion, const std::function<std::vector<Offer>()>& offers) {
  // while nodes start, the graph changes in many steps: check once it is stable
  const std::uint64_t version = ros_.participant().graph().version();
  const bool isQuiet = std::exchange(seenVersion_, version) == version;
  if (!isQuiet || (version == checkedVersion_ && offersVersion == offersVersion_)) return;
  checkedVersion_ = version;
  offersVersion_ = offersVersion;

  const std::vector<Graph::Endpoint> endpoints = ros_.participant().graph().endpoints();
  std::erase_if(warned_, [&](const Guid& id) {
    return std::ranges::none_of(endpoints, [&](const Graph::Endpoint& endpoint) { return endpoint.id == id; });
  });
  for (const Offer& offer : offers()) {
    const std::string topic = topicOnWire(offer.ros);
    for (const Graph::Endpoint& endpoint : endpoints) {
      if (endpoint.contract.topic != topic || warned_.contains(endpoint.id)) continue;
      if (const auto why = mismatch(offer, endpoint)) {
        warned_.insert(endpoint.id);
        ros_.log().warning(*why);
      }
    }
  }
}

}  // namespace pongsim::ros2
