#include "point_cloud.hh"

#include <cstddef>

namespace pongsim {

void beginCloud(std::span<const PointField> fields, std::uint32_t columns, std::uint32_t rows,
                ignition::msgs::PointCloudPacked& cloud) {
  for (const PointField& each : fields) {
    ignition::msgs::PointCloudPacked::Field& field = *cloud.add_field();
    field.set_name(each.name);
    field.set_offset(each.offset);
    field.set_datatype(each.type);
    field.set_count(1);
  }
  cloud.set_width(columns);
  cloud.set_height(rows);
  cloud.set_point_step(kPointSize);
  cloud.set_row_step(kPointSize * columns);
}

}  // namespace pongsim
