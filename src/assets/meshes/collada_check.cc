#include "assets/meshes/collada_check.hh"

#include <algorithm>
#include <array>
#include <cassert>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "assets/meshes/collada_xml.hh"
#include "assets/meshes/mesh_file.hh"
#include "assets/meshes/mesh_import.hh"

namespace pongsim::assets {

namespace {

using tinyxml2::XMLElement;

constexpr std::size_t kMostInputs = 64;
/// Limit for corners of triangles and polygons together: meshes with more triangles are refused anyway.
constexpr std::uint64_t kMostCorners = 3 * kMostTriangles;
constexpr std::uint64_t kMostNodes = 100'000;
constexpr std::size_t kMostColorComponents = 4;

template <class Value>
using ByName = std::map<std::string, Value, std::less<>>;

std::string inQuotes(std::string_view name) { return "'" + std::string(name) + "'"; }

/// Checks the arrays and meshes of `<library_geometries>`.
class GeometryCheck {
 public:
  explicit GeometryCheck(const XMLElement& collada) {
    forEachInside(collada, [this](const XMLElement& element) {
      const std::string_view name = element.Name();
      if (name == "float_array") addArray(element, true);
      if (name == "Name_array" || name == "IDREF_array") addArray(element, false);
      if (name == "input" && attributeOf(element, "semantic") == "COLOR")
        colors_.insert(attributeOf(element, "source"));
    });
    forEachChild(collada, "library_geometries", [this](const XMLElement& library) {
      forEachChild(library, "geometry", [this](const XMLElement& geometry) { check(geometry); });
    });
  }

  /// @return The number of corners of each geometry's triangles and polygons.
  const ByName<std::uint64_t>& corners() const { return corners_; }

 private:
  void addArray(const XMLElement& array, bool hasNumbers) {
    const std::uint64_t count = numberIn(array, "count", 0);
    if (count > textOf(array).size()) refuseElement(array, "has fewer values than its count");
    const std::uint64_t values = hasNumbers ? count : 0;
    const auto [known, isNew] = arrays_.emplace(attributeOf(array, "id"), values);
    if (!isNew) known->second = std::min(known->second, values);
  }

  void checkAccessor(const XMLElement& accessor, bool isColor) {
    std::uint64_t paramCount = 0;
    forEachInside(accessor, [&](const XMLElement& param) {
      if (param.Name() == std::string_view("param")) ++paramCount;
      const bool isTooMuch = paramCount > kMostColorComponents || attributeOf(param, "type") == "float4x4";
      if (isColor && isTooMuch) refuseElement(accessor, "has more components than a color");
    });
    const std::uint64_t count = numberIn(accessor, "count", 0);
    const std::uint64_t offset = numberIn(accessor, "offset", 0);
    const std::uint64_t stride = numberIn(accessor, "stride", 1);
    const auto array = arrays_.find(referenceIn(accessor, "source"));
    if (array == arrays_.end() || count == 0) return;
    const std::uint64_t last = offset + (count - 1) * stride + std::max<std::uint64_t>(paramCount, 1) - 1;
    if (last >= array->second) refuseElement(accessor, "goes past the end of the array " + inQuotes(array->first));
  }

  void checkSource(const XMLElement& source) {
    const bool isColor = colors_.contains("#" + std::string(attributeOf(source, "id")));
    forEachInside(source, [&](const XMLElement& element) {
      if (element.Name() == std::string_view("accessor")) checkAccessor(element, isColor);
    });
  }

  void check(const XMLElement& geometry) {
    const XMLElement* mesh = geometry.FirstChildElement("mesh");
    if (mesh == nullptr) return;
    if (const XMLElement* second = mesh->NextSiblingElement("mesh"))
      refuseElement(*second, "is the second <mesh> of its <geometry>");
    std::uint64_t corners = 0;
    std::size_t positionCount = 0;
    const XMLElement* primitives = nullptr;
    forEachInside(*mesh, [&](const XMLElement& element) {
      const std::string_view name = element.Name();
      if (name == "source" || name == "vertices") {
        if (primitives != nullptr)
          refuseElement(element, "must stand before <" + std::string(primitives->Name()) + ">");
      }
      if (name == "source") checkSource(element);
      if (name == "vertices") positionCount += positionsOf(element);
      if (!isPrimitives(name)) return;
      if (positionCount != 1) refuseElement(element, "needs <vertices> with one input of POSITION before it");
      primitives = &element;
      corners += checkPrimitives(element);
    });
    corners_.emplace(attributeOf(geometry, "id"), corners);
  }

  static bool isPrimitives(std::string_view name) {
    constexpr std::array<std::string_view, 5> kNames{"triangles", "polylist", "polygons", "trifans", "tristrips"};
    return std::ranges::find(kNames, name) != kNames.end();
  }

  static std::size_t positionsOf(const XMLElement& vertices) {
    std::size_t inputCount = 0;
    std::size_t positionCount = 0;
    forEachChild(vertices, "input", [&](const XMLElement& input) {
      if (++inputCount > kMostInputs)
        refuseElement(input, "exceeds the limit of " + std::to_string(kMostInputs) + " inputs");
      if (attributeOf(input, "semantic") == "POSITION") ++positionCount;
    });
    return positionCount;
  }

  /// @return The number of corners.
  static std::uint64_t checkPrimitives(const XMLElement& primitives) {
    const std::string_view kind = primitives.Name();
    const std::uint64_t count = numberIn(primitives, "count", 0);
    std::size_t inputCount = 0;
    std::uint64_t width = 1;
    bool hasVertex = false;
    std::uint64_t sizeCount = 0;
    std::uint64_t expected = kind == "triangles" ? 3 * count : 0;
    std::uint64_t corners = 0;
    std::uint64_t listCount = 0;
    forEachInside(primitives, [&](const XMLElement& element) {
      const std::string_view name = element.Name();
      if (name == "input") {
        if (++inputCount > kMostInputs)
          refuseElement(element, "exceeds the limit of " + std::to_string(kMostInputs) + " inputs");
        const std::uint64_t offset = numberIn(element, "offset", 0);
        if (offset >= kMostInputs)
          refuseElement(element, "has an offset of more than " + std::to_string(kMostInputs - 1));
        width = std::max(width, offset + 1);
        hasVertex = hasVertex || attributeOf(element, "semantic") == "VERTEX";
      }
      if (name == "vcount") {
        std::vector<std::int32_t> sizes = numbersIn(element);
        sizes.resize(std::min<std::uint64_t>(sizes.size(), count));
        for (const std::int32_t size : sizes) {
          if (size < 0) refuseElement(element, "contains a negative number");
          if (kind == "polylist") expected += static_cast<std::uint64_t>(size);
        }
        sizeCount += sizes.size();
      }
      if (name != "p") return;
      ++listCount;
      if (!hasVertex) refuseElement(element, "needs an <input> of VERTEX before it");
      const std::uint64_t indexCount = numbersIn(element).size();
      const bool lacksSizes = kind == "polylist" && sizeCount < count;
      if (lacksSizes || expected > indexCount || expected * width > indexCount) {
        refuseElement(element, "has fewer indices than its <" + std::string(kind) + "> says");
      }
      corners += indexCount / width * (kind == "tristrips" ? 3 : 1);
    });
    // Debian's build of Assimp ends the process if these differ
    const bool isOneList = kind == "triangles" || kind == "polylist";
    if ((isOneList && count > 0 && listCount != 1) || (kind == "polygons" && listCount != count)) {
      refuseElement(primitives, "has the wrong number of <p>");
    }
    return corners;
  }

  ByName<std::uint64_t> arrays_;
  /// References to the sources of colors: "#NAME".
  std::set<std::string_view> colors_;
  ByName<std::uint64_t> corners_;
};

/// Checks the size of the scene after each reference to a node has been replaced by the node, as Assimp does it.
class SceneCheck {
 public:
  SceneCheck(const XMLElement& collada, const ByName<std::uint64_t>& corners) : corners_(corners) {
    addLibraries(collada, "library_nodes", "node");
    addLibraries(collada, "library_visual_scenes", "visual_scene");
    forEachChild(collada, "scene", [this](const XMLElement& scene) {
      forEachChild(scene, "instance_visual_scene", [this](const XMLElement& instance) {
        const std::string_view wanted = referenceIn(instance, "url");
        if (wanted.empty()) refuseElement(instance, "refers to no scene");
        const auto root = library_.find(wanted);
        if (root == library_.end()) return;
        root_ = root->second;
        costOf(*root_, 0);
      });
    });
  }

 private:
  struct Cost {
    std::uint64_t nodes = 1;
    std::uint64_t corners = 0;
    int depth = 1;
  };

  void addLibraries(const XMLElement& collada, const char* libraries, const char* nodes) {
    forEachChild(collada, libraries, [&](const XMLElement& library) {
      forEachChild(library, nodes, [&](const XMLElement& node) {
        const std::string_view id = attributeOf(node, "id");
        if (!library_.emplace(id, &node).second && !id.empty()) refuseElement(node, "has the same id as another one");
      });
    });
  }

  /// @return The first node of the scene with this name or id.
  static const XMLElement* find(const XMLElement& node, std::string_view wanted) {
    const char* unnamed = node.Name() == std::string_view("visual_scene") ? "Scene" : "";
    const char* name = node.Attribute("name");
    if (wanted == (name != nullptr ? name : unnamed) || wanted == attributeOf(node, "id")) return &node;
    const XMLElement* found = nullptr;
    forEachChild(node, "node", [&](const XMLElement& child) {
      if (found == nullptr) found = find(child, wanted);
    });
    return found;
  }

  const XMLElement* resolve(const XMLElement& instance) const {
    const std::string_view wanted = referenceIn(instance, "url");
    if (wanted.empty()) refuseElement(instance, "refers to no node");
    const auto known = library_.find(wanted);
    if (known != library_.end()) return known->second;
    assert(root_ != nullptr);
    return find(*root_, wanted);
  }

  Cost costOf(const XMLElement& node, int depth) {
    if (const auto known = costs_.find(&node); known != costs_.end()) {
      if (!known->second) refuseElement(node, "contains itself");
      if (depth + known->second->depth > kDeepestNode) refuseElement(node, "is nested too deeply");
      return *known->second;
    }
    if (depth >= kDeepestNode) refuseElement(node, "is nested too deeply");
    costs_[&node] = std::nullopt;
    Cost cost;
    const auto add = [&](const XMLElement& child) {
      const Cost added = costOf(child, depth + 1);
      cost.nodes += added.nodes;
      cost.corners += added.corners;
      cost.depth = std::max(cost.depth, added.depth + 1);
      checkLimits(child, cost);
    };
    forEachChild(node, "node", add);
    forEachChild(node, "instance_node", [&](const XMLElement& instance) {
      if (const XMLElement* child = resolve(instance)) add(*child);
    });
    forEachChild(node, "instance_geometry", [&](const XMLElement& instance) {
      const std::string_view wanted = referenceIn(instance, "url");
      if (wanted.empty()) refuseElement(instance, "refers to no geometry");
      const auto corners = corners_.find(wanted);
      if (corners != corners_.end()) cost.corners += corners->second;
      checkLimits(instance, cost);
    });
    costs_[&node] = cost;
    return cost;
  }

  static void checkLimits(const XMLElement& element, const Cost& cost) {
    if (cost.nodes > kMostNodes) {
      refuseElement(element, "makes more than " + std::to_string(kMostNodes) + " nodes, which is the limit");
    }
    if (cost.corners > kMostCorners) {
      refuseElement(element, "makes more than " + std::to_string(kMostTriangles) + " triangles, which is the limit");
    }
  }

  const ByName<std::uint64_t>& corners_;
  ByName<const XMLElement*> library_;
  const XMLElement* root_ = nullptr;
  /// Unset while a node is being visited, so that a cycle is detected.
  std::map<const XMLElement*, std::optional<Cost>> costs_;
};

/// Checks that no parameter of an effect refers back to itself, directly or through others.
void checkEffect(const XMLElement& effect) {
  ByName<std::string_view> references;
  forEachInside(effect, [&](const XMLElement& param) {
    if (param.Name() != std::string_view("newparam")) return;
    std::string_view reference;
    forEachInside(param, [&](const XMLElement& element) {
      const std::string_view name = element.Name();
      const XMLElement* image = element.FirstChildElement("init_from");
      if (name == "surface" && image != nullptr) reference = textOf(*image);
      if (name == "sampler2D") reference = referenceIn(element, "url");
      if (name == "source") reference = textOf(element);
    });
    references.insert_or_assign(std::string(attributeOf(param, "sid")), reference);
  });
  std::set<std::string_view> leadToImages;
  for (const auto& [sid, first] : references) {
    std::set<std::string_view> passed;
    for (auto at = references.find(sid); at != references.end(); at = references.find(at->second)) {
      if (leadToImages.contains(at->first)) break;
      if (!passed.insert(at->first).second)
        refuseElement(effect, "has the parameter " + inQuotes(sid) + ", which refers back to itself");
    }
    leadToImages.merge(passed);
  }
}

}  // namespace

void checkCollada(const XMLElement& collada) {
  const GeometryCheck geometries(collada);
  const SceneCheck scene(collada, geometries.corners());
  forEachChild(collada, "library_effects", [](const XMLElement& library) {
    forEachChild(library, "effect", [](const XMLElement& effect) { checkEffect(effect); });
  });
}

}  // namespace pongsim::assets
