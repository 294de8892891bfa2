#include "sdf/includes/addresses.hh"

#include <gtest/gtest.h>

namespace pongsim::sdf {
namespace {

Element elementOf(const std::string& name, const std::string& text, std::vector<Element> children = {}) {
  Element element;
  element.name = name;
  element.text = text;
  element.children = std::move(children);
  return element;
}

TEST(Addresses, OfFuelServersAreFoundWhereverTheyStand) {
  const std::string model = "https://fuel.gazebosim.org/1.0/o/models/";
  const Element world =
      elementOf("world", "",
                {elementOf("include", "", {elementOf("uri", model + "a"), elementOf("name", model + "no")}),
                 elementOf("mesh", "", {elementOf("uri", "model://b/c.dae")}),
                 elementOf("metal", "", {elementOf("albedo_map", model + "d/1/files/e.png")}),
                 // a system may insert this one later
                 elementOf("plugin", "", {elementOf("include", "", {elementOf("uri", model + "f")})})});
  EXPECT_EQ(fuelAddressesIn(world), (std::vector<std::string>{model + "a", model + "d/1/files/e.png", model + "f"}));
  EXPECT_TRUE(fuelAddressesIn(elementOf("world", "")).empty());
}

}  // namespace
}  // namespace pongsim::sdf
