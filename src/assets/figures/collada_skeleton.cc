#include "assets/figures/collada_skeleton.hh"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "assets/meshes/collada_xml.hh"
#include "assets/meshes/mesh_file.hh"
#include "base/parse_number.hh"
#include "pongsim/math.hh"

namespace pongsim::assets {

namespace {

using tinyxml2::XMLElement;

constexpr std::size_t kMostBones = 10'000;
constexpr std::size_t kMatrixSize = 16;
// of one node: they are kept for each time of its motion
constexpr std::size_t kMostSteps = 64;
// instances of one skin add up
constexpr std::size_t kMostJoints = 10'000;
constexpr std::size_t kMostVertices = 3 * kMostTriangles;

std::vector<double> realsIn(const XMLElement& element) {
  std::optional<std::vector<double>> values = base::parseDoubles(textOf(element));
  const auto isFinite = [](double value) { return std::isfinite(value); };
  if (!values || !std::ranges::all_of(*values, isFinite)) refuseElement(element, "contains what is no finite number");
  return *std::move(values);
}

Eigen::Affine3d matrixOf(const XMLElement& element, const double* values) {
  Eigen::Affine3d matrix = Eigen::Affine3d::Identity();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) matrix.matrix()(row, column) = values[4 * row + column];
  }
  if (!(std::abs(matrix.linear().determinant()) > 0)) refuseElement(element, "is a matrix without an inverse");
  return matrix;
}

/// One of the elements that a node's transform is made of.
struct Step {
  std::string id;
  std::string kind;
  std::vector<double> values;

  Eigen::Affine3d transform(const XMLElement& node) const {
    if (kind == "matrix") return matrixOf(node, values.data());
    const Vector3 vector(values[0], values[1], values[2]);
    if (kind == "translate") return Eigen::Affine3d(Eigen::Translation3d(vector));
    if (kind == "scale") return Eigen::Affine3d(Eigen::Scaling(vector));
    if (vector.isZero()) return Eigen::Affine3d::Identity();
    return Eigen::Affine3d(rotationAbout(vector.normalized(), values[3] * std::numbers::pi / 180));
  }
};

std::vector<Step> stepsOf(const XMLElement& node) {
  static const std::map<std::string_view, std::size_t> kSizes{
      {"matrix", kMatrixSize}, {"translate", 3}, {"scale", 3}, {"rotate", 4}};
  std::vector<Step> steps;
  for (const auto* child = node.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
    const auto size = kSizes.find(child->Name());
    if (size == kSizes.end()) continue;
    steps.push_back({std::string(attributeOf(*child, "sid")), child->Name(), realsIn(*child)});
    if (steps.back().values.size() != size->second) {
      refuseElement(*child, "does not have " + std::to_string(size->second) + " numbers");
    }
    if (steps.size() > kMostSteps) refuseElement(node, "has too many transforms");
  }
  return steps;
}

Eigen::Affine3d product(const std::vector<Step>& steps, const XMLElement& node) {
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  for (const Step& step : steps) transform = transform * step.transform(node);
  return transform;
}

/// The name by which skins and animations know a node, as in Fortress.
std::string nameOf(const XMLElement& node) {
  for (const char* attribute : {"sid", "name", "id"}) {
    if (!attributeOf(node, attribute).empty()) return std::string(attributeOf(node, attribute));
  }
  return {};
}

class Reader {
 public:
  explicit Reader(const XMLElement& collada) : collada_(collada) {
    forEachInside(collada, [this](const XMLElement& element) {
      if (const std::string_view id = attributeOf(element, "id"); !id.empty()) ids_.emplace(id, &element);
    });
  }

  std::optional<Skeleton> read() {
    readUnit();
    forEachIn("library_visual_scenes", [this](const XMLElement& element) {
      if (element.Name() == std::string_view("instance_controller")) readInstance(element);
    });
    std::vector<const XMLElement*> channels;
    forEachIn("library_animations", [&channels](const XMLElement& element) {
      if (element.Name() == std::string_view("channel")) channels.push_back(&element);
    });
    // a file may have nothing but a motion
    if (skeleton_.bones.empty() && channels.empty()) return std::nullopt;
    readMotion(channels);
    return std::move(skeleton_);
  }

 private:
  /// Calls `visit` with each element inside the libraries of that name.
  template <class Visit>
  void forEachIn(const char* library, const Visit& visit) const {
    forEachChild(collada_, library, [&](const XMLElement& each) { forEachInside(each, visit); });
  }

  const XMLElement* named(std::string_view id) const {
    const auto found = ids_.find(id.starts_with('#') ? id.substr(1) : id);
    return found == ids_.end() ? nullptr : found->second;
  }

  const XMLElement& required(const XMLElement& from, const char* reference) const {
    const XMLElement* found = named(attributeOf(from, reference));
    if (found == nullptr) refuseElement(from, std::string("has a ") + reference + " that is not there");
    return *found;
  }

  static const XMLElement& child(const XMLElement& parent, const char* name) {
    const XMLElement* found = parent.FirstChildElement(name);
    if (found == nullptr) refuseElement(parent, std::string("has no <") + name + ">");
    return *found;
  }

  /// @return What the child `<input>` of that semantic refers to; null if there is none.
  const XMLElement* inputOf(const XMLElement& parent, std::string_view semantic) const {
    const XMLElement* found = nullptr;
    forEachChild(parent, "input", [&](const XMLElement& input) {
      if (attributeOf(input, "semantic") == semantic) found = &input;
    });
    return found;
  }

  const XMLElement& sourceOf(const XMLElement& parent, std::string_view semantic) const {
    const XMLElement* input = inputOf(parent, semantic);
    if (input == nullptr) refuseElement(parent, "has no <input> of " + std::string(semantic));
    return required(*input, "source");
  }

  void readUnit() {
    const XMLElement* asset = collada_.FirstChildElement("asset");
    const XMLElement* unit = asset != nullptr ? asset->FirstChildElement("unit") : nullptr;
    if (unit == nullptr) return;
    const std::optional<double> metres = base::parseDouble(attributeOf(*unit, "meter"));
    if (metres && std::isfinite(*metres) && *metres > 0) skeleton_.unit = *metres;
  }

  /// Adds a node with all below it.
  void addBones(const XMLElement& node, std::size_t parent) {
    const std::size_t bone = skeleton_.bones.size();
    if (bone >= kMostBones) refuseElement(node, "is one of more than " + std::to_string(kMostBones) + " bones");
    skeleton_.bones.push_back({nameOf(node), parent, product(stepsOf(node), node)});
    boneOf_.emplace(nameOf(node), bone);
    forEachChild(node, "node", [&](const XMLElement& next) { addBones(next, bone); });
  }

  /// @return What an instance's `<skeleton>`s name, or the topmost node around its first joint.
  std::vector<const XMLElement*> rootsOf(const XMLElement& instance, const std::vector<std::string>& joints) const {
    std::vector<const XMLElement*> roots;
    forEachChild(instance, "skeleton", [&](const XMLElement& element) {
      roots.push_back(named(textOf(element)));
      if (roots.back() == nullptr) refuseElement(element, "names a node that is not there");
    });
    if (!roots.empty()) return roots;
    const XMLElement* found = nullptr;
    forEachIn("library_visual_scenes", [&](const XMLElement& element) {
      if (found == nullptr && !joints.empty() && nameOf(element) == joints[0]) found = &element;
    });
    if (found == nullptr) refuseElement(instance, "has a skin without a skeleton");
    const auto isInNode = [](const XMLElement& element) {
      const XMLElement* parent = element.Parent()->ToElement();
      return parent != nullptr && parent->Name() == std::string_view("node");
    };
    while (isInNode(*found)) found = found->Parent()->ToElement();
    return {found};
  }

  static std::vector<std::string> wordsIn(const XMLElement& element) {
    std::vector<std::string> words;
    const std::string_view text = textOf(element);
    constexpr std::string_view kSpaces = " \t\r\n";
    for (std::size_t at = text.find_first_not_of(kSpaces); at < text.size(); at = text.find_first_not_of(kSpaces, at)) {
      const std::size_t end = std::min(text.find_first_of(kSpaces, at), text.size());
      words.emplace_back(text.substr(at, end - at));
      at = end;
    }
    return words;
  }

  std::vector<std::string> jointNames(const XMLElement& joints) const {
    const XMLElement& source = sourceOf(joints, "JOINT");
    const XMLElement* names = source.FirstChildElement("Name_array");
    return wordsIn(names != nullptr ? *names : child(source, "IDREF_array"));
  }

  /// @return From the positions of the mesh to the file's frame, with its unit.
  Eigen::Affine3d placeOf(const XMLElement& instance) const {
    Eigen::Affine3d place = Eigen::Affine3d::Identity();
    for (const XMLElement* node = instance.Parent()->ToElement();
         node != nullptr && node->Name() == std::string_view("node"); node = node->Parent()->ToElement()) {
      place = product(stepsOf(*node), *node) * place;
    }
    return Eigen::Scaling(skeleton_.unit) * place;
  }

  void readInstance(const XMLElement& instance) {
    const XMLElement* skin = required(instance, "url").FirstChildElement("skin");
    // a morphed mesh
    if (skin == nullptr) return;
    const XMLElement& joints = child(*skin, "joints");
    const std::vector<std::string> names = jointNames(joints);
    for (const XMLElement* root : rootsOf(instance, names)) {
      if (!boneOf_.contains(nameOf(*root))) addBones(*root, skeleton_.bones.size());
    }

    Eigen::Affine3d M_SkinShape = Eigen::Affine3d::Identity();
    if (const XMLElement* bind = skin->FirstChildElement("bind_shape_matrix")) {
      const std::vector<double> values = realsIn(*bind);
      if (values.size() != kMatrixSize) refuseElement(*bind, "does not have 16 numbers");
      M_SkinShape = matrixOf(*bind, values.data());
    }
    const XMLElement& poses = child(sourceOf(joints, "INV_BIND_MATRIX"), "float_array");
    const std::vector<double> values = realsIn(poses);
    if (values.size() < names.size() * kMatrixSize) refuseElement(poses, "has fewer matrices than there are joints");
    const Eigen::Affine3d M_FileShape = placeOf(instance);
    if (!(std::abs(M_FileShape.linear().determinant()) > 0)) refuseElement(instance, "is in a node of no size");
    const std::size_t first = skeleton_.joints.size();
    if (first + names.size() > kMostJoints) refuseElement(instance, "has too many joints");
    for (std::size_t i = 0; i < names.size(); ++i) {
      const auto bone = boneOf_.find(names[i]);
      if (bone == boneOf_.end()) refuseElement(*skin, "has the joint '" + names[i] + "', which its skeleton lacks");
      const Eigen::Affine3d M_BoneSkin = matrixOf(poses, &values[i * kMatrixSize]);
      skeleton_.joints.push_back({bone->second, M_BoneSkin * M_SkinShape * M_FileShape.inverse()});
    }
    readWeights(*skin, M_FileShape, first, names.size());
  }

  std::vector<Vector3> positionsOf(const XMLElement& skin) const {
    const XMLElement& geometry = required(skin, "source");
    const XMLElement& array = child(sourceOf(child(child(geometry, "mesh"), "vertices"), "POSITION"), "float_array");
    const std::vector<double> values = realsIn(array);
    std::vector<Vector3> positions;
    for (std::size_t i = 0; i + 2 < values.size(); i += 3) {
      positions.emplace_back(values[i], values[i + 1], values[i + 2]);
    }
    return positions;
  }

  void readWeights(const XMLElement& skin, const Eigen::Affine3d& M_FileShape, std::size_t firstJoint,
                   std::size_t jointCount) {
    const std::vector<Vector3> positions = positionsOf(skin);
    const XMLElement& list = child(skin, "vertex_weights");
    if (skeleton_.vertices.size() + positions.size() > kMostVertices) refuseElement(list, "is for too many vertices");
    const std::vector<double> weights = realsIn(child(sourceOf(list, "WEIGHT"), "float_array"));
    const std::vector<std::int32_t> counts = numbersIn(child(list, "vcount")), all = numbersIn(child(list, "v"));
    const XMLElement* jointInput = inputOf(list, "JOINT");
    if (jointInput == nullptr) refuseElement(list, "has no <input> of JOINT");
    const std::uint64_t jointAt = numberIn(*jointInput, "offset", 0),
                        weightAt = numberIn(*inputOf(list, "WEIGHT"), "offset", 0);
    const std::uint64_t stride = std::max(jointAt, weightAt) + 1;
    std::size_t at = 0;
    for (std::size_t i = 0; i < counts.size() && i < positions.size(); ++i) {
      Skeleton::Vertex vertex{M_FileShape * positions[i], {}};
      double sum = 0;
      for (std::int32_t j = 0; j < counts[i]; ++j, at += stride) {
        if (at + stride > all.size()) refuseElement(list, "has fewer weights than it counts");
        const std::int32_t joint = all[at + jointAt], weight = all[at + weightAt];
        // -1 is the shape itself
        if (joint < 0) continue;
        if (static_cast<std::size_t>(joint) >= jointCount || weight < 0 ||
            static_cast<std::size_t>(weight) >= weights.size()) {
          refuseElement(list, "refers to a joint or a weight that is not there");
        }
        vertex.influences.push_back(
            {firstJoint + static_cast<std::size_t>(joint), weights[static_cast<std::size_t>(weight)]});
        sum += vertex.influences.back().weight;
      }
      if (!(sum > 0)) continue;
      for (Skeleton::Influence& each : vertex.influences) each.weight /= sum;
      skeleton_.vertices.push_back(std::move(vertex));
    }
  }

  /// Frames of a node: the values of its steps, at each time.
  using RawFrames = std::map<double, std::vector<Step>>;

  void readMotion(const std::vector<const XMLElement*>& channels) {
    std::map<const XMLElement*, RawFrames> frames;
    for (const XMLElement* channel : channels) readChannel(*channel, frames);
    for (const auto& [node, raw] : frames) {
      Track& track = skeleton_.motion.tracks[nameOf(*node)];
      for (const auto& [time, steps] : raw) track.add(time, product(steps, *node));
    }
  }

  /// @return Which numbers of a step a channel sets: "(1)(2)", ".X", or nothing for all.
  static std::optional<std::size_t> indexIn(const XMLElement& channel, std::string_view target) {
    static const std::map<std::string_view, std::size_t> kNames{{"X", 0}, {"Y", 1}, {"Z", 2}, {"ANGLE", 3}};
    const std::size_t at = target.find_first_of(".(");
    if (at == std::string_view::npos) return std::nullopt;
    const std::string_view rest = target.substr(at);
    if (rest[0] == '.') {
      if (const auto found = kNames.find(rest.substr(1)); found != kNames.end()) return found->second;
    } else if (rest.size() == 3 && rest[1] >= '0' && rest[1] <= '9') {
      return static_cast<std::size_t>(rest[1] - '0');
    } else if (rest.size() == 6 && rest[1] >= '0' && rest[1] <= '3' && rest[4] >= '0' && rest[4] <= '3') {
      return static_cast<std::size_t>(4 * (rest[1] - '0') + rest[4] - '0');
    }
    refuseElement(channel, "has a target that can't be read");
  }

  void readChannel(const XMLElement& channel, std::map<const XMLElement*, RawFrames>& frames) const {
    const std::string_view target = attributeOf(channel, "target");
    const std::size_t slash = target.find('/');
    const XMLElement* node = named(target.substr(0, slash));
    if (slash == std::string_view::npos || node == nullptr || node->Name() != std::string_view("node")) return;
    const std::string_view rest = target.substr(slash + 1);
    const std::string_view id = rest.substr(0, rest.find_first_of(".("));
    const std::optional<std::size_t> index = indexIn(channel, rest);
    const XMLElement& sampler = required(channel, "source");
    const std::vector<double> times = realsIn(child(sourceOf(sampler, "INPUT"), "float_array"));
    const XMLElement& output = child(sourceOf(sampler, "OUTPUT"), "float_array");
    const std::vector<double> values = realsIn(output);
    if (times.empty()) return;
    const std::size_t stride = values.size() / times.size();
    if (stride == 0) refuseElement(output, "has fewer values than there are times");
    const std::vector<Step> atRest = stepsOf(*node);
    for (std::size_t i = 0; i < times.size(); ++i) {
      std::vector<Step>& steps = frames[node].try_emplace(times[i], atRest).first->second;
      for (Step& step : steps) {
        if (step.id != id) continue;
        if (index) {
          if (*index < step.values.size()) step.values[*index] = values[i * stride];
        } else {
          std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(i * stride), std::min(stride, step.values.size()),
                      step.values.begin());
        }
      }
    }
  }

  const XMLElement& collada_;
  std::map<std::string_view, const XMLElement*> ids_;
  std::map<std::string, std::size_t> boneOf_;
  Skeleton skeleton_;
};

}  // namespace

std::optional<Skeleton> colladaSkeleton(const std::string& content) {
  tinyxml2::XMLDocument document;
  if (document.Parse(content.data(), content.size()) != tinyxml2::XML_SUCCESS) {
    throw std::runtime_error("the XML is not well-formed");
  }
  const XMLElement* collada = document.FirstChildElement("COLLADA");
  if (collada == nullptr) throw std::runtime_error("there is no <COLLADA>");
  return Reader(*collada).read();
}

}  // namespace pongsim::assets
