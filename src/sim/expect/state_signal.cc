#include "sim/expect/state_signal.hh"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "base/nearest_word.hh"
#include "base/text.hh"
#include "pongsim/actor.hh"
#include "pongsim/scene.hh"

namespace pongsim::sim {

namespace {

/// More names than this are no help.
constexpr std::size_t kMostNamed = 12;

/// Numbers of a kind of signal, in the order of its names.
using Numbers = std::vector<double>;

std::string hintFrom(const std::string& name, const std::vector<std::string>& known) {
  const std::vector<std::string_view> words(known.begin(), known.end());
  const std::string hint = base::didYouMean(name, words);
  if (!hint.empty()) return " (" + hint + ")";
  return known.empty() || known.size() > kMostNamed ? "" : " (there is: " + base::listed(words) + ")";
}

void addNames(const std::vector<Model>& models, std::vector<std::string>& modelNames, std::vector<std::string>& links,
              std::vector<std::string>& joints) {
  for (const Model& model : models) {
    const std::string name = model.scopedName();
    modelNames.push_back(name);
    for (const Link& link : model.links()) links.push_back(link.scopedName());
    for (const Joint& joint : model.joints()) joints.push_back(name + "::" + std::string(joint.name()));
    addNames(model.models(), modelNames, links, joints);
  }
}

/// @return A model, or a link of one, by its scoped name.
std::optional<Link> findLink(const World& world, const std::string& name) {
  const std::size_t colons = name.rfind("::");
  if (colons == std::string::npos) return std::nullopt;
  const std::optional<Model> model = world.model(name.substr(0, colons));
  return model ? model->link(name.substr(colons + 2)) : std::nullopt;
}

std::optional<Joint> findJoint(const World& world, const std::string& name) {
  const std::size_t colons = name.rfind("::");
  if (colons == std::string::npos) return std::nullopt;
  const std::optional<Model> model = world.model(name.substr(0, colons));
  return model ? model->joint(name.substr(colons + 2)) : std::nullopt;
}

/// Reads the numbers of a signal that the criteria use.
struct Source {
  std::vector<std::string> fields;
  /// @return Whether there are any.
  std::function<bool(Numbers&)> read;
};

/// @param models More that there is, besides models.
std::string notThere(const World& world, const std::string& name, std::vector<std::string> models = {}) {
  std::vector<std::string> links, joints;
  addNames(world.models(), models, links, joints);
  const bool isLink = name.find("::") != std::string::npos;
  return std::string("there is no ") + (isLink ? "link" : "model") + " '" + name + "'" +
         hintFrom(name, isLink ? links : models);
}

Outcome<Source> poseSource(const World& world, const std::string& name) {
  const auto take = [](const Pose& pose, Numbers& to) {
    const Vector3 angles = rollPitchYawOf(pose.rotation);
    to = {pose.position.x(), pose.position.y(), pose.position.z(), angles.x(), angles.y(), angles.z()};
    return true;
  };
  const std::vector<std::string> fields{"x", "y", "z", "roll", "pitch", "yaw"};
  if (const auto model = world.model(name)) {
    return {Source{fields, [=, model = *model](Numbers& to) { return model.exists() && take(model.pose(), to); }}, ""};
  }
  if (const auto link = findLink(world, name)) {
    return {Source{fields, [=, link = *link](Numbers& to) { return link.exists() && take(link.pose(), to); }}, ""};
  }
  if (const auto actor = Actor::find(world, name)) {
    return {Source{fields, [=, actor = *actor](Numbers& to) { return actor.exists() && take(actor.pose(), to); }}, ""};
  }
  std::vector<std::string> actors;
  for (const ActorPlace& actor : Scene(world).actors()) actors.emplace_back(actor.name);
  return {{}, notThere(world, name, std::move(actors))};
}

Outcome<Source> velocitySource(const World& world, const std::string& name) {
  std::optional<Link> link = findLink(world, name);
  if (const auto model = world.model(name)) {
    link = model->canonicalLink();
    if (!link) return {{}, "model '" + name + "' has no link of its own (name one: " + name + "::LINK)"};
  }
  if (!link) return {{}, notThere(world, name)};
  const std::vector<std::string> fields{"x", "y", "z", "speed", "roll", "pitch", "yaw"};
  return {Source{fields,
                 [link = *link](Numbers& to) {
                   if (!link.exists()) return false;
                   const Vector3 v = link.linearVelocity(), w = link.angularVelocity();
                   to = {v.x(), v.y(), v.z(), v.norm(), w.x(), w.y(), w.z()};
                   return true;
                 }},
          ""};
}

Outcome<Source> jointSource(const World& world, const std::string& name) {
  const std::optional<Joint> joint = findJoint(world, name);
  if (!joint) {
    std::vector<std::string> models, links, joints;
    addNames(world.models(), models, links, joints);
    return {{}, "there is no joint '" + name + "'" + hintFrom(name, joints)};
  }
  if (joint->axisCount() == 0) return {{}, "joint '" + name + "' has no axis with a position"};
  return {Source{{"position", "velocity"},
                 [joint = *joint](Numbers& to) {
                   if (!joint.exists()) return false;
                   to = {joint.position(), joint.velocity()};
                   return true;
                 }},
          ""};
}

/// Which collisions belong to the two sides of a contact, found out once for each.
class Sides {
 public:
  Sides(const World& world, std::string first, std::string second)
      : world_(world), first_(std::move(first)), second_(std::move(second)) {}

  bool areOf(const Contact& contact) {
    const int one = sidesOf(contact.collision1), other = sidesOf(contact.collision2);
    return ((one & kFirst) != 0 && (other & kSecond) != 0) || ((one & kSecond) != 0 && (other & kFirst) != 0);
  }

 private:
  static constexpr int kFirst = 1, kSecond = 2;

  static bool isPartOf(const std::string& part, const std::string& whole) {
    return part == whole || (part.starts_with(whole) && part.compare(whole.size(), 2, "::") == 0);
  }

  int sidesOf(CollisionId id) {
    const auto [known, isNew] = known_.try_emplace(id, 0);
    if (!isNew) return known->second;
    const std::optional<Collision> collision = world_.collision(id);
    const std::string name = collision ? collision->scopedName() : "";
    if (isPartOf(name, first_)) known->second |= kFirst;
    if (second_.empty() || isPartOf(name, second_)) known->second |= kSecond;
    return known->second;
  }

  World world_;
  std::string first_, second_;
  std::map<CollisionId, int> known_;
};

/// @return The first of the names that no collision of the world belongs to.
std::optional<std::string> unknownSide(const World& world, const std::vector<std::string>& sides,
                                       std::vector<std::string>& known) {
  std::vector<std::string> joints, links;
  addNames(world.models(), known, links, joints);
  for (const std::string& link : links) {
    known.push_back(link);
    const std::optional<Link> found = findLink(world, link);
    if (!found) continue;
    for (const Collision& collision : found->collisions()) known.push_back(collision.scopedName());
  }
  for (const std::string& side : sides) {
    if (!side.empty() && std::find(known.begin(), known.end(), side) == known.end()) return side;
  }
  return std::nullopt;
}

Outcome<Source> contactSource(const World& world, const Signal& signal, const ContactPoints& contacts) {
  std::vector<std::string> known;
  if (const auto unknown = unknownSide(world, {signal.name, signal.other}, known)) {
    return {{}, "there is no model, link or collision '" + *unknown + "'" + hintFrom(*unknown, known)};
  }
  auto sides = std::make_shared<Sides>(world, signal.name, signal.other);
  return {Source{{"touching", "points", "depth", "force"},
                 [sides, &contacts](Numbers& to) {
                   double points = 0, depth = 0;
                   Vector3 force = Vector3::Zero();
                   for (const Contact& contact : contacts) {
                     if (!sides->areOf(contact)) continue;
                     ++points;
                     depth = std::max(depth, contact.depth);
                     force += contact.force;
                   }
                   to = {points > 0 ? 1.0 : 0.0, points, depth, force.norm()};
                   return true;
                 }},
          ""};
}

Outcome<Source> sourceOf(const World& world, const Signal& signal, const ContactPoints& contacts) {
  switch (signal.kind) {
    case Signal::Kind::kPose:
      return poseSource(world, signal.name);
    case Signal::Kind::kVelocity:
      return velocitySource(world, signal.name);
    case Signal::Kind::kJoint:
      return jointSource(world, signal.name);
    default:
      return contactSource(world, signal, contacts);
  }
}

}  // namespace

Outcome<StateSignal> stateSignal(World world, const Event& event, const ContactPoints& contacts) {
  Outcome<Source> source = sourceOf(world, event.signal, contacts);
  if (!source) return {{}, source.error};
  StateSignal result;
  std::vector<std::size_t> places;
  for (const Criterion& criterion : event.criteria) {
    const auto& fields = source->fields;
    const auto found = std::find(fields.begin(), fields.end(), criterion.field);
    if (found == fields.end()) {
      const std::vector<std::string_view> words(fields.begin(), fields.end());
      return {{}, "it has no field '" + criterion.field + "' (there is: " + base::listed(words) + ")"};
    }
    if (criterion.text) return {{}, "field '" + criterion.field + "' is a number, and not '" + *criterion.text + "'"};
    places.push_back(static_cast<std::size_t>(found - fields.begin()));
    const bool isTurn = criterion.field == "roll" || criterion.field == "pitch" || criterion.field == "yaw";
    result.isAngle.push_back(event.signal.kind == Signal::Kind::kPose && isTurn);
  }
  result.read = [read = std::move(source->read), places = std::move(places),
                 numbers = Numbers()](std::span<FieldValue> to) mutable {
    if (!read(numbers)) return false;
    for (std::size_t i = 0; i < places.size(); ++i) to[i].number = numbers[places[i]];
    return true;
  };
  return {std::move(result), ""};
}

}  // namespace pongsim::sim
