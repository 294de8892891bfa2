#include "world_requests.hh"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <map>
#include <stdexcept>

namespace pongsim {

namespace {

/// With all digits.
std::string word(double number) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.17g", number);
  return text;
}
std::string word(std::uint64_t id) { return std::to_string(id); }
Words flag(bool value) { return {value ? "1" : "0"}; }

template <class Vector>
void append(Words& words, const Vector& vector) {
  for (int i = 0; i < 3; ++i) words.push_back(word(vector[i]));
}

Words wordsOf(const Vector3& one) {
  Words words;
  append(words, one);
  return words;
}

Words wordsOf(const Vector3& one, const Vector3& other) {
  Words words = wordsOf(one);
  append(words, other);
  return words;
}

Words wordsOf(const Vector3& position, const Quaternion& q) {
  Words words = wordsOf(position);
  for (const double part : {q.w(), q.x(), q.y(), q.z()}) words.push_back(word(part));
  return words;
}

template <class Part>
Words idsOf(const std::vector<Part>& parts) {
  Words words;
  for (const Part& part : parts) words.push_back(word(part.id().value));
  return words;
}

/// @return Its id, or Gazebo's null entity.
template <class Part>
Words idOf(const std::optional<Part>& part) {
  return {word(part ? part->id().value : 0)};
}

/// The words behind the id.
struct Arguments {
  std::span<const std::string> words;

  const std::string& text() const {
    if (words.empty()) throw std::runtime_error("a name is missing");
    return words[0];
  }
  double number(std::size_t i) const {
    if (i >= words.size()) throw std::runtime_error("too few numbers");
    double value = 0;
    const std::string& word = words[i];
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || !std::isfinite(value))
      throw std::runtime_error("'" + word + "' is not a finite number");
    return value;
  }
  Vector3 vector(std::size_t i) const { return {number(i), number(i + 1), number(i + 2)}; }
};

void check(const Outcome<void>& outcome) {
  if (!outcome) throw std::runtime_error(outcome.error);
}

Words ofWorld(World& world, const std::string& what, const Arguments& arguments) {
  if (what == "entity") return {word(world.id().value)};
  if (what == "valid") return {"1"};
  if (what == "name") return {std::string(world.name())};
  if (what == "gravity") return wordsOf(world.gravity());
  if (what == "magnetic_field") return wordsOf(world.magneticField());
  if (what == "models") return idsOf(world.models());
  if (what == "model_by_name") return idOf(world.model(arguments.text()));
  throw std::runtime_error("a world has no " + what);
}

Words ofModel(Model model, const std::string& what, const Arguments& arguments) {
  if (what == "name") return {std::string(model.name())};
  if (what == "static") return flag(model.isStatic());
  if (what == "links") return idsOf(model.links());
  if (what == "joints") return idsOf(model.joints());
  if (what == "models") return idsOf(model.models());
  if (what == "link_by_name") return idOf(model.link(arguments.text()));
  if (what == "joint_by_name") return idOf(model.joint(arguments.text()));
  if (what == "canonical_link") return idOf(model.canonicalLink());
  if (what == "set_world_pose") {
    const Quaternion q(arguments.number(3), arguments.number(4), arguments.number(5), arguments.number(6));
    if (!(q.norm() > 0)) throw std::runtime_error("a rotation is no quaternion");
    check(model.setPose({arguments.vector(0), q.normalized()}));
    return {};
  }
  throw std::runtime_error("a model has no " + what);
}

Words ofLink(Link link, const std::string& what, const Arguments& arguments) {
  if (what == "name") return {std::string(link.name())};
  if (what == "parent_model") return {word(link.model().id().value)};
  if (what == "wind_mode") return flag(link.isInWind());
  if (what == "world_pose") {
    const Pose pose = link.pose();
    return wordsOf(pose.position, pose.rotation);
  }
  if (what == "inertial_pose") {
    const MassInfo mass = link.mass();
    return wordsOf(mass.center, mass.axes);
  }
  if (what == "velocity") return wordsOf(link.linearVelocity(), link.angularVelocity());
  if (what == "set_velocity") {
    link.setVelocity(arguments.vector(0), arguments.vector(3));
    return {};
  }
  if (what == "add_wrench") {
    link.addWrench(arguments.vector(0), arguments.vector(3));
    return {};
  }
  throw std::runtime_error("a link has no " + what);
}

Words ofJoint(Joint joint, const std::string& what, const Arguments& arguments) {
  if (what == "name") return {std::string(joint.name())};
  if (what == "parent_model") return {word(joint.child().model().id().value)};
  if (what == "child_link_name") return {std::string(joint.child().name())};
  if (what == "parent_link_name") {
    const std::optional<Link> parent = joint.parent();
    return {parent ? std::string(parent->name()) : "world"};
  }
  Words words;
  for (int axis = 0; axis < joint.axisCount(); ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    if (what == "position") {
      words.push_back(word(joint.position(axis)));
    } else if (what == "velocity") {
      words.push_back(word(joint.velocity(axis)));
    } else if (what == "set_force") {
      joint.addForce(arguments.number(i), axis);
    } else if (what == "set_velocity") {
      joint.setVelocityTarget(arguments.number(i), axis);
    } else if (what == "reset_position") {
      check(joint.resetPosition(arguments.number(i), axis));
    } else if (what == "reset_velocity") {
      check(joint.resetVelocity(arguments.number(i), axis));
    } else {
      throw std::runtime_error("a joint has no " + what);
    }
  }
  return words;
}

template <class Part>
Words answerOf(const std::optional<Part>& part, const char* kind, const std::string& what, const Arguments& arguments,
               Words (*answer)(Part, const std::string&, const Arguments&)) {
  if (what == "valid") return flag(part.has_value());
  if (!part) throw std::runtime_error(std::string("there is no such ") + kind);
  return answer(*part, what, arguments);
}

}  // namespace

Words answerRequest(World& world, const Words& request) {
  if (request.size() < 2) throw std::runtime_error("a request is too short");
  const std::size_t dot = request[0].find('.');
  const std::string kind = request[0].substr(0, dot), what = dot < request[0].size() ? request[0].substr(dot + 1) : "";
  std::uint64_t id = 0;
  std::from_chars(request[1].data(), request[1].data() + request[1].size(), id);
  const Arguments arguments{std::span(request).subspan(2)};
  if (kind == "world") return ofWorld(world, what, arguments);
  if (kind == "model") return answerOf(world.model(ModelId{id}), "model", what, arguments, ofModel);
  if (kind == "link") return answerOf(world.link(LinkId{id}), "link", what, arguments, ofLink);
  if (kind == "joint") return answerOf(world.joint(JointId{id}), "joint", what, arguments, ofJoint);
  throw std::runtime_error("there is no kind '" + kind + "' of entities");
}

}  // namespace pongsim
