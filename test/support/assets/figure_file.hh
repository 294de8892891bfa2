#pragma once

#include <string>

namespace pongsim::test {

/// A figure of two squares of 0.2 m that are seen from both sides: a body at the bone "hips", the skeleton's root, and
/// a hand at (0, 0, 0.6) of the bone "arm", which is at (0, 0, 0.5) of "hips". The file has "hips" 0.9 m above its
/// origin, below a node that does not count.
struct FigureFile {
  /// Of the bone "arm".
  std::string arm = "arm";
  std::string unit = "1";
  /// Whether its mesh is a skin.
  bool isSkin = true;
  /// Whether "hips" goes by 2 along x within a second, while "arm" turns by 90 degrees about x.
  bool moves = true;

  /// @return In Collada.
  std::string text() const {
    return R"(<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><unit meter=")" +
           unit +
           R"("/></asset><library_geometries><geometry id="g" name="g"><mesh><source id="p"><float_array id="pa" count="24">
0 -0.1 0.8 0 0.1 0.8 0 0.1 1 0 -0.1 1 0 -0.1 1.9 0 0.1 1.9 0 0.1 2.1 0 -0.1 2.1</float_array><technique_common>
<accessor source="#pa" count="8" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source><vertices id="v"><input semantic="POSITION"
source="#p"/></vertices><triangles count="8"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2 0 2 3 0 2 1 0 3 2
4 5 6 4 6 7 4 6 5 4 7 6</p></triangles></mesh></geometry></library_geometries>)" +
           (isSkin ? skin() : "") + (moves ? motion() : "") + scene() + "</COLLADA>";
  }

 private:
  std::string skin() const {
    return R"(<library_controllers><controller id="c"><skin source="#g"><bind_shape_matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1
</bind_shape_matrix><source id="j"><Name_array id="ja" count="2">hips )" +
           arm + R"(</Name_array></source><source id="b"><float_array id="ba" count="32">
1 0 0 0 0 1 0 0 0 0 1 -0.9 0 0 0 1 1 0 0 0 0 1 0 0 0 0 1 -1.4 0 0 0 1</float_array></source><source id="w">
<float_array id="wa" count="2">1 0.5</float_array></source><joints><input semantic="JOINT" source="#j"/><input
semantic="INV_BIND_MATRIX" source="#b"/></joints><vertex_weights count="8"><input semantic="JOINT" source="#j" offset="0"/>
<input semantic="WEIGHT" source="#w" offset="1"/><vcount>1 1 1 1 1 1 1 1</vcount><v>0 0 0 0 0 0 0 0 1 0 1 0 1 0 1 0</v>
</vertex_weights></skin></controller></library_controllers>)";
  }

  std::string motion() const {
    const auto channel = [](const std::string& node, const std::string& first, const std::string& last) {
      const std::string id = node + "_motion";
      return R"(<animation><source id=")" + id + R"(_t"><float_array id=")" + id +
             R"(_ta" count="2">0 1</float_array></source>
<source id=")" +
             id + R"(_o"><float_array id=")" + id + R"(_oa" count="32">)" + first + " " + last +
             R"(</float_array></source><sampler id=")" + id + R"(_s"><input semantic="INPUT" source="#)" + id +
             R"(_t"/><input semantic="OUTPUT" source="#)" + id + R"(_o"/></sampler><channel source="#)" + id +
             R"(_s" target=")" + node + R"(/transform"/></animation>)";
    };
    return "<library_animations>" +
           channel("hips_id", "1 0 0 0 0 1 0 0 0 0 1 0.9 0 0 0 1", "1 0 0 2 0 1 0 0 0 0 1 0.9 0 0 0 1") +
           channel("arm_id", "1 0 0 0 0 1 0 0 0 0 1 0.5 0 0 0 1", "1 0 0 0 0 0 -1 0 0 1 0 0.5 0 0 0 1") +
           "</library_animations>";
  }

  std::string scene() const {
    return R"(<library_visual_scenes><visual_scene id="s"><node id="above"><translate>0 0 0</translate><node id="hips_id"
name="Hips" sid="hips" type="JOINT"><matrix sid="transform">1 0 0 0 0 1 0 0 0 0 1 0.9 0 0 0 1</matrix><node id="arm_id" sid=")" +
           arm +
           R"(" type="JOINT"><matrix sid="transform">1 0 0 0 0 1 0 0 0 0 1 0.5 0 0 0 1</matrix></node></node></node>
<node id="n" name="n">)" +
           (isSkin ? R"(<instance_controller url="#c"><skeleton>#hips_id</skeleton></instance_controller>)"
                   : R"(<instance_geometry url="#g"/>)") +
           R"(</node></visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene>)";
  }
};

}  // namespace pongsim::test
