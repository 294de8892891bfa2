#include "urdf/structure_check.hh"

#include <limits>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/nearest_word.hh"

namespace pongsim::urdf {

namespace {

/// Far more than any robot has, and far fewer than urdfdom can handle, which destroys trees recursively.
constexpr std::size_t kMostLinks = 5000;

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

/// The links and the parent joint of each.
class Structure {
 public:
  Structure(const Element& robot, Diagnostics& diagnostics) : robot_(robot), diagnostics_(diagnostics) {}

  bool check() {
    readNames();
    if (links_.empty()) fail(robot_.position, "the robot has no <link>");
    if (links_.size() > kMostLinks) {
      fail(robot_.position, "the robot has more than " + std::to_string(kMostLinks) + " links");
    }
    readJoints();
    // any further faults would be consequences
    if (isSound_) findRoot();
    if (isSound_) findCycle();
    return isSound_;
  }

 private:
  struct Link {
    const Element* xml;
    const Element* joint = nullptr;
    std::size_t parent = kNone;
  };

  void fail(const SourcePosition& position, std::string message, std::string hint = {}) {
    isSound_ = false;
    diagnostics_.error(position, std::move(message), std::move(hint));
  }

  const std::string* nameOf(const Element& part, const std::string& label) {
    const Element::Attribute* name = part.attribute("name");
    if (name != nullptr && !name->value.empty()) return &name->value;
    fail(part.position, label + " has no name");
    return nullptr;
  }

  void readNames() {
    nameOf(robot_, "the robot");
    std::unordered_map<std::string_view, const Element*> joints;
    for (const Element& part : robot_.children) {
      if (part.name != "link" && part.name != "joint") continue;
      const std::string* name = nameOf(part, "a " + part.name);
      if (name == nullptr) continue;
      const bool isNew =
          part.name == "link" ? numbers_.emplace(*name, links_.size()).second : joints.emplace(*name, &part).second;
      if (!isNew) fail(part.position, "there is a second " + part.name + " '" + *name + "'");
      if (part.name == "link") links_.push_back({&part});
    }
  }

  void readJoints() {
    for (const Element& joint : robot_.children) {
      if (joint.name != "joint") continue;
      const std::size_t parent = linkOf(joint, "parent");
      const std::size_t child = linkOf(joint, "child");
      if (parent == kNone || child == kNone) continue;
      Link& link = links_[child];
      const std::string name = joint.attributeOr("name", "");
      if (link.joint != nullptr) {
        fail(joint.child("child")->position,
             "joint '" + name + "' has the child '" + nameOf(child) + "', which is already the child of joint '" +
                 link.joint->attributeOr("name", "") + "'",
             "URDF does not support closed loops");
        continue;
      }
      link.joint = &joint;
      link.parent = parent;
    }
  }

  /// @return The link named by a joint as its parent or child.
  std::size_t linkOf(const Element& joint, std::string_view role) {
    const Element* element = joint.child(role);
    if (element == nullptr) return kNone;
    const std::string label = "joint '" + joint.attributeOr("name", "") + "'";
    const Element::Attribute* link = element->attribute("link");
    if (link == nullptr) {
      fail(element->position, "<" + element->name + "> of " + label + " has no attribute 'link'",
           "write <" + element->name + " link=\"...\"/>");
      return kNone;
    }
    const auto found = numbers_.find(link->value);
    if (found != numbers_.end()) return found->second;
    std::vector<std::string_view> known;
    for (const auto& [name, number] : numbers_) known.push_back(name);
    fail(link->position, label + " names " + element->name + " link '" + link->value + "', which does not exist",
         base::didYouMean(link->value, known));
    return kNone;
  }

  std::string nameOf(std::size_t link) const { return links_[link].xml->attribute("name")->value; }

  void findRoot() {
    std::size_t root = kNone;
    for (std::size_t i = 0; i < links_.size(); ++i) {
      if (links_[i].parent != kNone) continue;
      if (root == kNone) {
        root = i;
      } else {
        fail(links_[i].xml->position,
             "link '" + nameOf(i) + "' has no parent joint, and neither has '" + nameOf(root) + "'",
             "a robot has one root: every other link must be the child of a joint");
      }
    }
  }

  void findCycle() {
    // following parents ends at the root, at a link that was visited before, or where it began
    std::vector<std::size_t> visitedFrom(links_.size(), kNone);
    for (std::size_t start = 0; start < links_.size(); ++start) {
      std::size_t link = start;
      for (; link != kNone && visitedFrom[link] == kNone; link = links_[link].parent) visitedFrom[link] = start;
      if (link == kNone || visitedFrom[link] != start) continue;
      std::string way = "'" + nameOf(link) + "'";
      for (std::size_t next = links_[link].parent; next != link; next = links_[next].parent) {
        way += " is below '" + nameOf(next) + "', which";
      }
      fail(links_[link].joint->position, "the joints form a loop: " + way + " is below '" + nameOf(link) + "'");
    }
  }

  const Element& robot_;
  Diagnostics& diagnostics_;
  std::vector<Link> links_;
  std::unordered_map<std::string_view, std::size_t> numbers_;
  bool isSound_ = true;
};

}  // namespace

bool checkStructure(const Element& robot, Diagnostics& diagnostics) { return Structure(robot, diagnostics).check(); }

}  // namespace pongsim::urdf
