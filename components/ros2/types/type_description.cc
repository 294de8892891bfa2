#include "ros2/types/type_description.hh"

namespace pongsim::ros2::detail {

void FieldCollector::add(const char* name, const FieldType& type) { type_.fields.push_back({name, type}); }

}  // namespace pongsim::ros2::detail
