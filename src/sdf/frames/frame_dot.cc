#include "sdf/frames/frame_dot.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace pongsim::sdf {

namespace {

/// The frame that contains a world, or a model that is in no world.
constexpr std::string_view kRoot = "__root__";

std::string inQuotes(std::string_view text) {
  std::string result = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') result += '\\';
    result += letter;
  }
  return result + "\"";
}

std::string poseText(const Pose& pose) {
  const Vector3 angles = rollPitchYawOf(pose.rotation);
  std::string text;
  for (const double value :
       {pose.position.x(), pose.position.y(), pose.position.z(), angles.x(), angles.y(), angles.z()}) {
    std::array<char, 32> number{};
    // adding zero turns -0 into 0
    std::snprintf(number.data(), number.size(), "%.4g", std::round(value * 1e9) / 1e9 + 0.0);
    text += (text.empty() ? "" : " ") + std::string(number.data());
  }
  return text;
}

class DotWriter {
 public:
  explicit DotWriter(FrameGraphKind kind) : kind_(kind) {}

  std::string write(const Scope& scope) {
    const std::string& root = scope.frames().front().name;
    if (kind_ == FrameGraphKind::kPose && root != kRoot) {
      addNode(std::string(kRoot));
      addEdge(std::string(kRoot), root, Pose());
    }
    addNodes(scope, "");
    addEdges(scope, "");
    std::string text = "digraph {\n";
    for (const std::string& node : nodes_) text += "  " + node + "\n";
    for (const auto& [from, to, label] : edges_) {
      const auto begin = idOfName_.find(from), end = idOfName_.find(to);
      if (begin == idOfName_.end() || end == idOfName_.end()) continue;
      text += "  " + std::to_string(begin->second) + " -> " + std::to_string(end->second) + label + ";\n";
    }
    return text + "}\n";
  }

 private:
  struct Edge {
    std::string from;
    std::string to;
    std::string label;
  };

  void addNode(const std::string& name) {
    const std::string id = std::to_string(nodes_.size());
    idOfName_.emplace(name, nodes_.size());
    nodes_.push_back(id + " [label=" + inQuotes(name) + "];");
  }

  /// @param X_FromTo The label; printed in graphs of poses only.
  void addEdge(std::string from, std::string to, const std::optional<Pose>& X_FromTo) {
    const bool isLabelled = kind_ == FrameGraphKind::kPose && X_FromTo;
    edges_.push_back(
        {std::move(from), std::move(to), isLabelled ? " [label=" + inQuotes(poseText(*X_FromTo)) + "]" : ""});
  }

  /// @param prefix "model::" for frames of a model.
  void addNodes(const Scope& scope, const std::string& prefix) {
    for (const Scope::Frame& frame : scope.frames()) {
      addNode(prefix + frame.name);
      if (frame.inside != nullptr) addNodes(*frame.inside, prefix + frame.name + "::");
    }
  }

  void addEdges(const Scope& scope, const std::string& prefix) {
    const std::string& root = scope.frames().front().name;
    if (kind_ == FrameGraphKind::kFrame && !prefix.empty() && !scope.isStatic() && !scope.link(0).empty()) {
      addEdge(prefix + root, prefix + scope.link(0), std::nullopt);
    }
    for (std::size_t i = 1; i < scope.frames().size(); ++i) {
      const Scope::Frame& frame = scope.frames()[i];
      const std::string name = prefix + frame.name;
      if (frame.inside != nullptr) {
        addEdge(name, name + "::" + frame.inside->frames().front().name, Pose());
        addEdges(*frame.inside, name + "::");
      }
      const bool isAttached = frame.kind == FrameKind::kFrame || frame.kind == FrameKind::kJoint;
      std::string target = isAttached && !frame.attachedTo.empty() ? frame.attachedTo : root;
      if (kind_ == FrameGraphKind::kFrame) {
        if (isAttached) addEdge(name, prefix + target, std::nullopt);
        continue;
      }
      if (!frame.pose.relativeTo.empty()) target = frame.pose.relativeTo;
      const std::optional<Scope::ResolvedFrame> from = scope.find(target);
      if (from) addEdge(prefix + target, name, from->X_ScopeFrame.inverse() * scope.pose(i));
    }
  }

  FrameGraphKind kind_;
  std::vector<std::string> nodes_;
  std::map<std::string, std::size_t> idOfName_;
  std::vector<Edge> edges_;
};

}  // namespace

std::string frameDot(const Scope& scope, FrameGraphKind kind) { return DotWriter(kind).write(scope); }

}  // namespace pongsim::sdf
