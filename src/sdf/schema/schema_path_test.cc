#include "sdf/schema/schema_path.hh"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace pongsim::sdf::test {
namespace {

/// @return The path in the table, and behind it in brackets where it stands; or the message and hint.
std::string found(std::string_view path) {
  const auto result = findPart(path);
  if (const auto* none = std::get_if<NoPart>(&result)) return none->message + " | " + none->hint;
  const NamedPart& named = std::get<NamedPart>(result);
  std::string text(named.part->row.path);
  for (const std::string_view holder : named.holders) text += " (" + std::string(holder) + ")";
  return text;
}

TEST(SchemaPath, BeginsAnywhere) {
  EXPECT_EQ(found("sdf"), "sdf");
  EXPECT_EQ(found("joint"), "joint (actor) (model) (state.insertions) (world)");
  EXPECT_EQ(found("joint/axis/limit/upper"), "joint.axis.limit.upper (joint.axis.limit)");
  EXPECT_EQ(found("axis/limit"), "joint.axis.limit (joint.axis)");
  EXPECT_EQ(found("//link/inertial"), "link.inertial (link)");
  EXPECT_EQ(found("/sdf/world/model/link/"), "model.link (model)");
  EXPECT_EQ(found("restitution_coefficient"), "surface.bounce.restitution_coefficient (surface.bounce)");
}

TEST(SchemaPath, NamesAttributes) {
  EXPECT_EQ(found("joint/@type"), "joint@type (joint)");
  EXPECT_EQ(found("joint@type"), "joint@type (joint)");
  EXPECT_EQ(found("axis/xyz/@expressed_in"), "joint.axis.xyz@expressed_in (joint.axis.xyz)");
  EXPECT_EQ(userPath("joint.axis.xyz@expressed_in"), "joint/axis/xyz/@expressed_in");
}

TEST(SchemaPath, SaysWhatIsMeant) {
  EXPECT_EQ(found("joitn"), "SDF has no element 'joitn' | did you mean 'joint'?");
  EXPECT_EQ(found("joint/axs/limit"), "SDF has no element 'axs' in <joint> | did you mean 'axis'?");
  EXPECT_EQ(found("joint/@typ"), "SDF has no attribute 'typ' in <joint> | did you mean '@type'?");
  EXPECT_EQ(found("joint/parent/x"), "SDF has no element 'x' in <parent> | ");
  EXPECT_EQ(found("plugin/*"), "SDF has no element '*' in <plugin> | ");
  EXPECT_EQ(found("limit"),
            "element 'limit' is in several elements, with different meanings | one of joint/axis/limit, "
            "joint/axis2/limit, joint/physics/ode/limit");
  for (const char* path : {"", "/", "//"}) {
    EXPECT_EQ(found(path), "no element is given | for example 'joint' or 'joint/axis/limit'");
  }
  EXPECT_EQ(found("@"), "SDF has no attribute '' | ");
}

}  // namespace
}  // namespace pongsim::sdf::test
