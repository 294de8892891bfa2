#pragma once

#include <sdf/sdf.hh>
#include <string>

#include "description/world.hh"

namespace pongsim::test {

/// Each expects that both descriptions are equal.
void compareLight(const description::Light& a, const ::sdf::Light& b, const std::string& what);
void compareLooks(const description::Visual& a, const ::sdf::Visual& b, const std::string& what);
void compareScene(const description::Scene& a, const ::sdf::Scene& b);
void compareActor(const description::Actor& a, const ::sdf::Actor& b, const std::string& what);

}  // namespace pongsim::test
