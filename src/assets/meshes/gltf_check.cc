#include "assets/meshes/gltf_check.hh"

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "assets/meshes/mesh_file.hh"
#include "assets/meshes/mesh_import.hh"

namespace pongsim::assets {

namespace {

using nlohmann::json;

constexpr std::string_view kBinaryStart = "glTF";
// version, length of the file; then length and kind of each chunk
constexpr std::size_t kGlbHeader = 12, kGlbChunkHeader = 8;
// RapidJSON, which Assimp uses, parses recursively
constexpr int kDeepestJson = 200;

std::uint32_t wordAt(std::string_view bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (unsigned i = 0; i < 4; ++i) number |= std::uint32_t{static_cast<std::uint8_t>(bytes[at + i])} << (8 * i);
  return number;
}

/// @return The JSON of a .glb file, which is its first chunk.
std::string_view jsonOf(std::string_view file) {
  if (!file.starts_with(kBinaryStart)) return file;
  std::string_view text;
  for (std::size_t at = kGlbHeader; at < file.size();) {
    if (file.size() - at < kGlbChunkHeader) break;
    const std::size_t length = wordAt(file, at);
    const std::size_t room = file.size() - at - kGlbChunkHeader;
    if (length > room) {
      throw std::runtime_error("a chunk claims " + std::to_string(length) + " bytes, where the file has " +
                               std::to_string(room));
    }
    if (at == kGlbHeader) text = file.substr(at + kGlbChunkHeader, length);
    // Assimp takes each chunk to begin at a multiple of four
    at += kGlbChunkHeader + (length + 3) / 4 * 4;
  }
  return text;
}

json parse(std::string_view text) {
  const auto check = [](int depth, json::parse_event_t, json&) {
    if (depth > kDeepestJson) throw std::runtime_error("its JSON is nested too deeply");
    return true;
  };
  try {
    return json::parse(text.begin(), text.end(), check);
  } catch (const json::parse_error& error) {
    throw std::runtime_error("its JSON is not well-formed at byte " + std::to_string(error.byte));
  }
}

/// The nodes by what refers to them: their number in glTF 2, their name in glTF 1.
class Nodes {
 public:
  explicit Nodes(const json& nodes) {
    for (const auto& [key, node] : nodes.items()) {
      if (node.is_object() && node.contains("children")) children_.emplace(key, &node["children"]);
    }
  }

  void check() const {
    std::map<std::string, std::string> parents;
    for (const auto& [parent, children] : children_) {
      for (const json& child : *children) {
        if (!parents.emplace(nameOf(child), parent).second)
          throw std::runtime_error("node " + nameOf(child) + " has two parents");
      }
    }
    for (const auto& [node, parent] : parents) checkDepth(node, parents);
  }

 private:
  static std::string nameOf(const json& reference) {
    return reference.is_string() ? reference.get<std::string>() : reference.dump();
  }

  static void checkDepth(const std::string& node, const std::map<std::string, std::string>& parents) {
    int depth = 0;
    for (auto at = parents.find(node); at != parents.end(); at = parents.find(at->second)) {
      if (++depth > kDeepestNode) {
        throw std::runtime_error("node " + node + " is nested more than " + std::to_string(kDeepestNode) +
                                 " nodes deep, or in itself");
      }
    }
  }

  std::map<std::string, const json*> children_;
};

/// @param member Of each of the list's objects: a number of bytes or values.
void checkAmounts(const json& root, const char* list, const char* member, std::uint64_t most) {
  const auto found = root.find(list);
  if (found == root.end()) return;
  for (const json& each : *found) {
    if (!each.is_object()) continue;
    const auto amount = each.find(member);
    if (amount == each.end()) continue;
    if (!amount->is_number_unsigned() || amount->get<std::uint64_t>() > most) {
      throw std::runtime_error(std::string(member) + " " + amount->dump() + " in " + list +
                               " is not a number from 0 to " + std::to_string(most));
    }
  }
}

}  // namespace

void checkGltf(std::string_view content) {
  const json root = parse(jsonOf(content));
  if (!root.is_object()) throw std::runtime_error("its JSON is no object");
  checkAmounts(root, "buffers", "byteLength", kLargestMeshFile);
  checkAmounts(root, "bufferViews", "byteLength", kLargestMeshFile);
  checkAmounts(root, "accessors", "count", 3 * kMostTriangles);
  if (const auto nodes = root.find("nodes"); nodes != root.end()) Nodes(*nodes).check();
}

}  // namespace pongsim::assets
