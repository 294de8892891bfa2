#pragma once

#include <pybind11/pybind11.h>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/life.hh"
#include "core/memory.hh"
#include "pongsim/sensing/sensor.hh"

namespace pongsim::python {

/// One kind of reading of a sensor, as it comes: its numbers are written to where NumPy looks at them.
class Stream final : public Life::Pending {
 public:
  /// @param kind "ranges", "points", "image", "depth" or "message".
  Stream(const std::shared_ptr<Life>& life, const std::string& topic, const std::string& type, const std::string& kind);
  ~Stream() override { end(subscription_); }
  void letGo() override { end(subscription_); }

  /// @return Itself, where no other thread steps, so that nothing is written meanwhile.
  /// Raises Gone, Busy as `Life::use`.
  const Stream& use() const;

  std::string kind;
  /// Rows, columns and, of points, numbers of a point.
  std::vector<std::size_t> shape;
  /// As NumPy names it: "f8".
  std::string format;
  /// In whole nanoseconds of simulated time; of the reading that is in the memory.
  std::int64_t time = 0;
  std::uint64_t count = 0;
  std::shared_ptr<Memory> memory;
  /// Of scans, in a memory of their own.
  std::shared_ptr<Memory> intensities;
  /// Where the sensor itself wrote last: pixels and points without anything between.
  const void* written = nullptr;
  /// The whole message in binary form; of kinds that are no arrays.
  std::string message;
  std::string type;

 private:
  void hear(const Message& heard, const Bulk* bulk);
  void hearScan(const Message& heard);
  void hearBulk(const Message& heard, const Bulk* bulk);
  void* place(std::shared_ptr<Memory>& memory, std::size_t size);

  std::weak_ptr<Life> life_;
  Subscription subscription_;
};

/// A sensor, with what was heard of it so far.
struct PySensor {
  std::shared_ptr<Life> life;
  Sensor inner;
  std::map<std::string, std::shared_ptr<Stream>> streams;

  Sensor& use() {
    life->use();
    return inner;
  }
  /// Begins to listen where nothing does yet.
  /// Raises ValueError for what the sensor does not have.
  Stream& listen(const std::string& kind);
};

/// @return The sensor of that scoped name, "model::link::sensor", or of a name that only one has. Raises KeyError.
PySensor findSensor(const std::shared_ptr<Life>& life, const std::string& name);
/// @return The scoped names of all.
std::vector<std::string> sensorNames(Life& life);

/// Adds sensors and their memory.
void bindSensors(py::module_& module);

}  // namespace pongsim::python
