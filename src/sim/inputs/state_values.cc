#include "sim/inputs/state_values.hh"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <map>
#include <span>

#include "sim/api/access.hh"

namespace pongsim::sim {

namespace {

constexpr std::array<std::string_view, 13> kLinkFields{
    "position x",         "position y",         "position z",         "rotation w", "rotation x",
    "rotation y",         "rotation z",         "velocity x",         "velocity y", "velocity z",
    "angular velocity x", "angular velocity y", "angular velocity z",
};
constexpr std::array<std::string_view, 4> kJointFields{"position", "velocity", "position of axis 2",
                                                       "velocity of axis 2"};

/// Calls `use` with each number of a link's state, in the order of `kLinkFields`.
template <class Use>
void forEachNumber(const world::LinkState& link, const Use& use) {
  for (const double value : link.X_WorldLink.position) use(value);
  const Quaternion& q = link.X_WorldLink.rotation;
  for (const double value : {q.w(), q.x(), q.y(), q.z()}) use(value);
  for (const double value : link.v_WorldLink) use(value);
  for (const double value : link.w_WorldLink) use(value);
}

template <class Use>
void forEachNumber(const world::JointState& joint, const Use& use) {
  for (const double value : {joint.position, joint.velocity, joint.position2, joint.velocity2}) use(value);
}

/// With all digits that tell two numbers apart.
std::string textOf(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

/// The numbers of each kind of part by its name.
struct Kind {
  std::string_view name;
  const std::vector<std::string>& a;
  const std::vector<std::string>& b;
  std::span<const std::string_view> fields;
  std::span<const std::uint64_t> bitsA;
  std::span<const std::uint64_t> bitsB;
};

/// Collects lines, up to a number.
class Lines {
 public:
  explicit Lines(std::size_t most) : most_(most) {}
  void add(std::string line) {
    if (++count_ <= most_) lines_.push_back(std::move(line));
  }
  std::vector<std::string> take() {
    if (count_ > most_) lines_.push_back("and " + std::to_string(count_ - most_) + " more");
    return std::move(lines_);
  }

 private:
  std::size_t most_;
  std::size_t count_ = 0;
  std::vector<std::string> lines_;
};

void compare(const Kind& kind, Lines& lines) {
  std::map<std::string_view, std::size_t> indexInB;
  for (std::size_t i = 0; i < kind.b.size(); ++i) indexInB.emplace(kind.b[i], i);
  const std::size_t size = kind.fields.size();
  for (std::size_t i = 0; i < kind.a.size(); ++i) {
    const std::string what = std::string(kind.name) + " '" + kind.a[i] + "'";
    const auto found = indexInB.extract(kind.a[i]);
    if (found.empty()) {
      lines.add(what + " is only in the first");
      continue;
    }
    for (std::size_t field = 0; field < size; ++field) {
      const std::uint64_t a = kind.bitsA[i * size + field];
      const std::uint64_t b = kind.bitsB[found.mapped() * size + field];
      if (a == b) continue;
      lines.add(what + ", " + std::string(kind.fields[field]) + ": " + textOf(std::bit_cast<double>(a)) + " and " +
                textOf(std::bit_cast<double>(b)));
    }
  }
  for (const auto& [name, index] : indexInB) {
    lines.add(std::string(kind.name) + " '" + std::string(name) + "' is only in the second");
  }
}

}  // namespace

StateValues StateValues::of(const Access& access) {
  const world::Entities& entities = access.entities;
  const world::State& state = access.state;
  StateValues values;
  values.time = state.time.count();
  values.iterations = state.iterations;
  values.bits.reserve(state.links.size() * kLinkFields.size() + state.joints.size() * kJointFields.size());
  const auto add = [&values](double value) { values.bits.push_back(std::bit_cast<std::uint64_t>(value)); };
  for (world::Slot slot = 0; slot < entities.links().size(); ++slot) {
    const world::LinkRecord& link = entities.links()[slot];
    values.links.push_back(entities.models()[link.model].scopedName + "::" + link.description->name);
    forEachNumber(state.links[slot], add);
  }
  for (world::Slot slot = 0; slot < entities.joints().size(); ++slot) {
    const world::JointRecord& joint = entities.joints()[slot];
    const std::string model =
        joint.model == world::kNoSlot ? std::string() : entities.models()[joint.model].scopedName + "::";
    values.joints.push_back(model + joint.description->name);
    forEachNumber(state.joints[slot], add);
  }
  return values;
}

void StateValues::transfer(StateArchive& archive) {
  archive(time);
  archive(iterations);
  archive(links);
  archive(joints);
  archive(bits);
}

bool StateValues::isWhole() const {
  return bits.size() == links.size() * kLinkFields.size() + joints.size() * kJointFields.size();
}

std::uint64_t quickHash(const Access& access) {
  constexpr std::uint64_t kFactor = 0x9e3779b97f4a7c15;
  std::uint64_t hash = kFactor;
  // the rotation brings high bits, which a multiplication does not spread, down to where it does
  const auto add = [&hash](std::uint64_t bits) { hash = std::rotl(hash ^ bits, 29) * kFactor; };
  const auto addNumber = [&add](double value) { add(std::bit_cast<std::uint64_t>(value)); };
  const world::State& state = access.state;
  add(static_cast<std::uint64_t>(state.time.count()));
  add(state.iterations);
  for (const world::LinkState& link : state.links) forEachNumber(link, addNumber);
  for (const world::JointState& joint : state.joints) forEachNumber(joint, addNumber);
  return hash;
}

std::vector<std::string> differences(const StateValues& a, const StateValues& b, std::size_t most) {
  Lines lines(most);
  if (a.iterations != b.iterations) {
    lines.add("the world, number of steps: " + std::to_string(a.iterations) + " and " + std::to_string(b.iterations));
  }
  if (a.time != b.time) {
    lines.add("the world, time [ns]: " + std::to_string(a.time) + " and " + std::to_string(b.time));
  }
  if (!a.isWhole() || !b.isWhole()) return lines.take();
  const std::span<const std::uint64_t> bitsA(a.bits), bitsB(b.bits);
  const std::size_t linksA = a.links.size() * kLinkFields.size();
  const std::size_t linksB = b.links.size() * kLinkFields.size();
  compare({"link", a.links, b.links, kLinkFields, bitsA.first(linksA), bitsB.first(linksB)}, lines);
  compare({"joint", a.joints, b.joints, kJointFields, bitsA.subspan(linksA), bitsB.subspan(linksB)}, lines);
  return lines.take();
}

std::string textOf(const StateValues& values) {
  std::string text;
  auto bits = values.bits.begin();
  const auto add = [&](std::string_view kind, const std::string& name, std::span<const std::string_view> fields) {
    text += std::string(kind) + " " + name + "\n";
    for (const std::string_view field : fields) {
      const auto value = std::bit_cast<double>(*bits++);
      // most joints have one axis
      if (value != 0 || field.find("axis 2") == field.npos) {
        text += "  " + std::string(field) + ": " + textOf(value) + "\n";
      }
    }
  };
  if (!values.isWhole()) return text;
  for (const std::string& link : values.links) add("link", link, kLinkFields);
  for (const std::string& joint : values.joints) add("joint", joint, kJointFields);
  return text;
}

}  // namespace pongsim::sim
