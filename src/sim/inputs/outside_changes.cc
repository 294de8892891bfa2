#include "sim/inputs/outside_changes.hh"

#include <optional>

namespace pongsim::sim {

void OutsideChange::transfer(StateArchive& archive) {
  archive(kind, Kind::kRemove);
  archive(system);
  archive(id);
  archive(pose);
  archive(after);
  archive(linear);
  archive(angular);
  archive(source.isFile);
  archive(source.text);
  archive(source.name);
  archive(options.name);
  archive(options.pose);
  archive(options.allowRenaming);
  archive(options.nameSpace);
  archive(options.isFromOutside);
}

void OutsideChanges::keepSource(const std::shared_ptr<const description::Model>& model, OutsideChange::Source source) {
  std::erase_if(sources_, [](const auto& each) { return each.first.expired(); });
  sources_.emplace_back(model, std::move(source));
}

const OutsideChange::Source* OutsideChanges::sourceOf(const std::shared_ptr<const description::Model>& model) const {
  for (const auto& [kept, source] : sources_) {
    if (kept.lock() == model) return &source;
  }
  return nullptr;
}

}  // namespace pongsim::sim
