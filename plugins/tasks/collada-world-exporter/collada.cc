#include "collada.hh"

#include <array>
#include <cstddef>
#include <cstdio>
#include <initializer_list>
#include <numbers>
#include <string_view>

#include "pongsim/geometry/rotation_between.hh"
#include "xml_writer.hh"

namespace pongsim {

namespace {

using Corner = VisiblePart::Corner;
using Textures = std::map<std::filesystem::path, std::string>;

void append(double value, std::string& text) {
  std::array<char, 32> digits{};
  // enough digits to read back the same float
  std::snprintf(digits.data(), digits.size(), "%.9g", value);
  if (!text.empty()) text += ' ';
  text += digits.data();
}

std::string textOf(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) append(value, text);
  return text;
}

std::string colorText(const Eigen::Vector3f& color, double opacity = 1) {
  const Vector3 shares = color.cast<double>();
  return textOf({shares.x(), shares.y(), shares.z(), opacity});
}

std::string matrixText(const Pose& pose) {
  const Matrix3 axes = pose.rotation.toRotationMatrix();
  std::string text;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) append(axes(row, column), text);
    append(pose.position[row], text);
  }
  return text + " 0 0 0 1";
}

/// @return Position of the corner in the part's frame, with the part's size applied.
Vector3 scaledPosition(const VisiblePart& part, const Corner& corner) {
  return part.scale.cwiseProduct(corner.position.cast<double>());
}

Vector3 scaledNormal(const VisiblePart& part, const Corner& corner) {
  return corner.normal.cast<double>().cwiseQuotient(part.scale).stableNormalized();
}

/// Writes a `<source>`: numbers for each corner.
/// @param axes Names of a corner's numbers: "XYZ".
template <class Numbers>
void writeSource(const std::string& id, std::string_view axes, const VisiblePart& part, Numbers numbers,
                 XmlWriter& xml) {
  std::string all;
  for (const Corner& corner : part.corners) {
    const auto values = numbers(corner);
    for (Eigen::Index i = 0; i < values.size(); ++i) append(static_cast<double>(values[i]), all);
  }
  const std::string array = id + "-array";
  xml.begin("source", {{"id", id}, {"name", id}});
  xml.add("float_array", {{"id", array}, {"count", std::to_string(axes.size() * part.corners.size())}}, all);
  xml.begin("technique_common");
  xml.begin("accessor", {{"source", "#" + array},
                         {"count", std::to_string(part.corners.size())},
                         {"stride", std::to_string(axes.size())}});
  for (const char axis : axes) xml.add("param", {{"name", std::string(1, axis)}, {"type", "float"}});
  xml.end();
  xml.end();
  xml.end();
}

void writeGeometry(const VisiblePart& part, const std::string& number, XmlWriter& xml) {
  const std::string id = "mesh_" + number;
  xml.begin("geometry", {{"id", id}, {"name", part.name}});
  xml.begin("mesh");
  writeSource(
      id + "-Positions", "XYZ", part, [&](const Corner& corner) { return scaledPosition(part, corner); }, xml);
  writeSource(
      id + "-Normals", "XYZ", part, [&](const Corner& corner) { return scaledNormal(part, corner); }, xml);
  // COLLADA's texture coordinates count from the bottom
  writeSource(
      id + "-UVMap", "ST", part,
      [](const Corner& corner) { return Eigen::Vector2f(corner.coordinates.x(), 1 - corner.coordinates.y()); }, xml);
  xml.begin("vertices", {{"id", id + "-Vertex"}});
  xml.add("input", {{"semantic", "POSITION"}, {"source", "#" + id + "-Positions"}});
  xml.end();
  xml.begin("triangles", {{"material", "material_" + number}, {"count", std::to_string(part.triangles.size() / 3)}});
  xml.add("input", {{"semantic", "VERTEX"}, {"source", "#" + id + "-Vertex"}, {"offset", "0"}});
  xml.add("input", {{"semantic", "NORMAL"}, {"source", "#" + id + "-Normals"}, {"offset", "0"}});
  xml.add("input", {{"semantic", "TEXCOORD"}, {"source", "#" + id + "-UVMap"}, {"offset", "0"}, {"set", "0"}});
  // mirroring reverses the order of the corners
  const bool isMirrored = part.scale.prod() < 0;
  std::string indices;
  for (std::size_t i = 0; i + 2 < part.triangles.size(); i += 3) {
    for (const std::size_t k : {i, isMirrored ? i + 2 : i + 1, isMirrored ? i + 1 : i + 2}) {
      if (!indices.empty()) indices += ' ';
      indices += std::to_string(part.triangles[k]);
    }
  }
  xml.add("p", {}, indices);
  xml.end();
  xml.end();
  xml.end();
}

void writeImages(const Textures& textures, XmlWriter& xml) {
  if (textures.empty()) return;
  xml.begin("library_images");
  for (const auto& [file, name] : textures) {
    xml.begin("image", {{"id", "image_" + name}});
    xml.add("init_from", {}, "../materials/textures/" + name);
    xml.end();
  }
  xml.end();
}

/// Writes the surface and sampler for a texture.
void writeSampler(const std::string& image, XmlWriter& xml) {
  xml.begin("newparam", {{"sid", image + "_surface"}});
  xml.begin("surface", {{"type", "2D"}});
  xml.add("init_from", {}, image);
  xml.end();
  xml.end();
  xml.begin("newparam", {{"sid", image + "_sampler"}});
  xml.begin("sampler2D");
  xml.add("source", {}, image + "_surface");
  xml.add("minfilter", {}, "LINEAR");
  xml.add("magfilter", {}, "LINEAR");
  xml.end();
  xml.end();
}

void writeColor(const char* name, const std::string& color, XmlWriter& xml) {
  xml.begin(name);
  xml.add("color", {}, color);
  xml.end();
}

void writeEffect(const VisiblePart& part, const std::string& number, const Textures& textures, XmlWriter& xml) {
  const auto texture = textures.find(part.texture);
  const std::string image = texture == textures.end() ? "" : "image_" + texture->second;
  xml.begin("effect", {{"id", "material_" + number + "_fx"}});
  xml.begin("profile_COMMON");
  if (!image.empty()) writeSampler(image, xml);
  xml.begin("technique", {{"sid", "COMMON"}});
  xml.begin("phong");
  writeColor("emission", colorText(part.emissive), xml);
  writeColor("ambient", colorText(part.ambient), xml);
  if (image.empty()) {
    writeColor("diffuse", colorText(part.diffuse, part.opacity), xml);
  } else {
    xml.begin("diffuse");
    xml.add("texture", {{"texture", image + "_sampler"}, {"texcoord", "UVSET0"}});
    xml.end();
  }
  writeColor("specular", colorText(part.specular), xml);
  xml.begin("transparent", {{"opaque", "A_ONE"}});
  xml.add("color", {}, "1 1 1 1");
  xml.end();
  xml.begin("transparency");
  xml.add("float", {}, textOf({part.opacity}));
  xml.end();
  xml.end();
  xml.end();
  xml.end();
  xml.end();
}

void writeLight(const VisibleLight& light, const std::string& number, XmlWriter& xml) {
  const bool isDirectional = light.type == VisibleLight::Type::kDirectional;
  xml.begin("light", {{"id", "light_" + number}, {"name", light.name}});
  xml.begin("technique_common");
  xml.begin(isDirectional ? "directional" : light.type == VisibleLight::Type::kPoint ? "point" : "spot");
  xml.add("color", {}, textOf({light.diffuse.x(), light.diffuse.y(), light.diffuse.z()}));
  if (!isDirectional) {
    xml.add("constant_attenuation", {}, textOf({light.constantAttenuation}));
    xml.add("linear_attenuation", {}, textOf({light.linearAttenuation}));
    xml.add("quadratic_attenuation", {}, textOf({light.quadraticAttenuation}));
  }
  if (light.type == VisibleLight::Type::kSpot) {
    xml.add("falloff_angle", {}, textOf({light.outerAngle * 180 / std::numbers::pi}));
    xml.add("falloff_exponent", {}, textOf({light.falloff}));
  }
  xml.end();
  xml.end();
  xml.end();
}

void writePartNode(const std::string& number, const Pose& X_WorldPart, XmlWriter& xml) {
  xml.begin("node", {{"id", "node_" + number}});
  xml.add("matrix", {{"sid", "matrix"}}, matrixText(X_WorldPart));
  xml.begin("instance_geometry", {{"url", "#mesh_" + number}});
  xml.begin("bind_material");
  xml.begin("technique_common");
  xml.begin("instance_material", {{"symbol", "material_" + number}, {"target", "#material_" + number}});
  xml.add("bind_vertex_input", {{"semantic", "UVSET0"}, {"input_semantic", "TEXCOORD"}, {"input_set", "0"}});
  xml.end();
  xml.end();
  xml.end();
  xml.end();
  xml.end();
}

/// Lights of COLLADA shine along their -z.
void writeLightNode(const std::string& number, const VisibleLight& light, XmlWriter& xml) {
  Pose X_WorldNode = light.X_WorldLight;
  if (light.type != VisibleLight::Type::kPoint) {
    X_WorldNode.rotation = X_WorldNode.rotation * rotationBetween(-Vector3::UnitZ(), light.direction);
  }
  xml.begin("node", {{"id", "light_node_" + number}});
  xml.add("matrix", {{"sid", "matrix"}}, matrixText(X_WorldNode));
  xml.add("instance_light", {{"url", "#light_" + number}});
  xml.end();
}

/// Writes a library, with `write` called for each number below `count`. An empty library is left out.
template <class Write>
void writeLibrary(const char* name, std::size_t count, XmlWriter& xml, Write write) {
  if (count == 0) return;
  xml.begin(name);
  for (std::size_t i = 0; i < count; ++i) write(i, std::to_string(i));
  xml.end();
}

}  // namespace

void writeCollada(const std::vector<VisiblePart>& parts, const std::vector<VisibleLight>& lights,
                  const Textures& textures, std::ostream& out) {
  XmlWriter xml(out);
  xml.begin("COLLADA", {{"xmlns", "http://www.collada.org/2005/11/COLLADASchema"}, {"version", "1.4.1"}});
  xml.begin("asset");
  xml.begin("contributor");
  xml.add("authoring_tool", {}, "pongsim");
  xml.end();
  // the format requires a time, and the same world must give the same file
  xml.add("created", {}, "1970-01-01T00:00:00Z");
  xml.add("modified", {}, "1970-01-01T00:00:00Z");
  xml.add("unit", {{"name", "meter"}, {"meter", "1"}});
  xml.add("up_axis", {}, "Z_UP");
  xml.end();
  writeLibrary("library_geometries", parts.size(), xml,
               [&](std::size_t i, const std::string& number) { writeGeometry(parts[i], number, xml); });
  writeImages(textures, xml);
  writeLibrary("library_materials", parts.size(), xml, [&](std::size_t, const std::string& number) {
    xml.begin("material", {{"id", "material_" + number}});
    xml.add("instance_effect", {{"url", "#material_" + number + "_fx"}});
    xml.end();
  });
  writeLibrary("library_effects", parts.size(), xml,
               [&](std::size_t i, const std::string& number) { writeEffect(parts[i], number, textures, xml); });
  writeLibrary("library_lights", lights.size(), xml,
               [&](std::size_t i, const std::string& number) { writeLight(lights[i], number, xml); });
  xml.begin("library_visual_scenes");
  xml.begin("visual_scene", {{"id", "VisualScene"}, {"name", "VisualScene"}});
  for (std::size_t i = 0; i < parts.size(); ++i) writePartNode(std::to_string(i), parts[i].X_WorldPart, xml);
  for (std::size_t i = 0; i < lights.size(); ++i) writeLightNode(std::to_string(i), lights[i], xml);
  xml.end();
  xml.end();
  xml.begin("scene");
  xml.add("instance_visual_scene", {{"url", "#VisualScene"}});
  xml.end();
  xml.end();
}

}  // namespace pongsim
