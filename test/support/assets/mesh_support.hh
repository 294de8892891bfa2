#pragma once

#include <string>
#include <string_view>

namespace pongsim::test {

/// A tetrahedron with corners at the origin and at 1 m on each axis.
inline constexpr std::string_view kStl = R"(solid t
facet normal 0 0 -1
outer loop
vertex 0 0 0
vertex 0 1 0
vertex 1 0 0
endloop
endfacet
facet normal 0 -1 0
outer loop
vertex 0 0 0
vertex 1 0 0
vertex 0 0 1
endloop
endfacet
facet normal -1 0 0
outer loop
vertex 0 0 0
vertex 0 0 1
vertex 0 1 0
endloop
endfacet
facet normal 1 1 1
outer loop
vertex 1 0 0
vertex 0 1 0
vertex 0 0 1
endloop
endfacet
endsolid t
)";

/// Two objects: a square of two triangles at x = 1 m, and a triangle at x = 5 m.
inline constexpr std::string_view kObj = R"(o square
v 1 0 0
v 1 1 0
v 1 1 1
v 1 0 1
f 1 2 3 4
o triangle
v 5 0 0
v 5 2 0
v 5 0 2
f 5 6 7
)";

/// A triangle in decimetres, y up, placed by the nodes "left" and "right" at -10 dm and 10 dm on x.
inline constexpr std::string_view kCollada = R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><created>2020-01-01</created><modified>2020-01-01</modified><unit name="decimeter" meter="0.1"/>
<up_axis>Y_UP</up_axis></asset>
<library_geometries><geometry id="shape" name="shape"><mesh>
<source id="p"><float_array id="pa" count="9">0 0 0 10 0 0 0 0 20</float_array><technique_common>
<accessor source="#pa" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s" name="s">
<node id="l" name="left"><translate>-10 0 0</translate><instance_geometry url="#shape"/></node>
<node id="r" name="right"><translate>10 0 0</translate><instance_geometry url="#shape"/></node>
</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>
)";

/// A binary glTF file with one triangle.
inline std::string glb() {
  std::string json =
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"name":"n","mesh":0}],)"
      R"("meshes":[{"name":"m","primitives":[{"attributes":{"POSITION":0}}]}],)"
      R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,2,3]}],)"
      R"("bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36}]})";
  while (json.size() % 4 != 0) json += ' ';
  const float corners[] = {0, 0, 0, 1, 0, 0, 0, 2, 3};
  std::string file = "glTF";
  const auto append = [&file](std::size_t number) {
    for (int i = 0; i < 4; ++i) file += static_cast<char>((number >> (8 * i)) & 0xFFU);
  };
  append(2);
  append(12 + 8 + json.size() + 8 + sizeof corners);
  append(json.size());
  file += "JSON" + json;
  append(sizeof corners);
  file += std::string("BIN\0", 4);
  file.append(reinterpret_cast<const char*>(corners), sizeof corners);
  return file;
}

}  // namespace pongsim::test
