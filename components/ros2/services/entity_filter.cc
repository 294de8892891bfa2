#include "ros2/services/entity_filter.hh"

#include <re2/re2.h>

#include <algorithm>
#include <string>

namespace pongsim::ros2 {

namespace si = simulation_interfaces;

namespace {

/// POSIX Extended; RE2 matches in a time that is linear in the name's length.
RE2::Options posixExtended() {
  RE2::Options options(RE2::POSIX);
  options.set_log_errors(false);
  return options;
}

}  // namespace

EntityFilter::EntityFilter() = default;
EntityFilter::EntityFilter(EntityFilter&&) noexcept = default;
EntityFilter::~EntityFilter() = default;

std::optional<EntityFilter> EntityFilter::from(const si::EntityFilters& request, Result& result) {
  EntityFilter filter;
  filter.request_ = request;
  if (!request.filter.empty()) {
    filter.names_ = std::make_unique<RE2>(request.filter, posixExtended());
    if (!filter.names_->ok()) {
      result = failed("filter '" + request.filter.substr(0, 100) +
                      "' is not a regular expression (POSIX Extended): " + filter.names_->error().substr(0, 200));
      return std::nullopt;
    }
  }
  if (const auto error = filterError(request.tags)) {
    result = failed(*error);
    return std::nullopt;
  }
  if (request.bounds.type > si::Bounds::kTypeSphere) {
    result = refused(Result::kResultFeatureUnsupported,
                     "there is no type " + std::to_string(request.bounds.type) + " of bounds");
    return std::nullopt;
  }
  if (request.bounds.type != si::Bounds::kTypeEmpty) {
    Outcome<Region> region = Region::from(request.bounds);
    if (!region) {
      result = failed(region.error);
      return std::nullopt;
    }
    filter.region_ = std::move(region.value);
  }
  return filter;
}

bool EntityFilter::takes(const World& world, const Model& model, const EntityInfos& infos) const {
  if (names_ && !RE2::PartialMatch(model.scopedName(), *names_)) return false;
  const si::EntityInfo info = infos.of(world, model);
  if (!request_.categories.empty() &&
      std::ranges::find(request_.categories, info.category) == request_.categories.end()) {
    return false;
  }
  return matches(request_.tags, info.tags) && (!region_ || region_->overlaps(model));
}

}  // namespace pongsim::ros2
