#include "pongsim/world_edits.hh"

#include <utility>

#include "assets/finder.hh"
#include "description/model.hh"
#include "sim/edits/edit_queue.hh"
#include "sim/system_slot.hh"

namespace pongsim {

const std::string& ModelTemplate::name() const { return model_->name; }

Pose ModelTemplate::pose() const { return model_->X_ParentModel; }

bool ModelTemplate::isStatic() const { return model_->isStatic; }

WorldEdits::~WorldEdits() = default;

namespace {

/// Throws the first error, at `position` if it has none of its own, and adds the other diagnostics to `diagnostics`.
void throwFirst(const Diagnostics& found, const SourcePosition& position, Diagnostics& diagnostics) {
  std::optional<Diagnostic> first;
  for (const Diagnostic& diagnostic : found.all()) {
    if (diagnostic.severity == Severity::kError && !first) {
      first = diagnostic;
      if (first->position.line == 0) first->position = position;
    } else {
      diagnostics.warning(diagnostic.position, diagnostic.message, diagnostic.hint);
    }
  }
  if (first) throw Error(*first);
}

/// Notes that a system which stands outside inserts a model.
/// @param source Null: it is not known.
void noteInsertion(const sim::SystemSlot& owner, sim::OutsideChanges& notes, const sim::OutsideChange::Source* source,
                   const InsertOptions& options) {
  using enum sim::OutsideChange::Kind;
  if (source == nullptr) {
    ++notes.unnoted;
  } else {
    owner.note({.kind = source->isFile ? kInsertFile : kInsertText, .source = *source, .options = options});
  }
}

}  // namespace

ModelTemplate WorldEdits::read(const Element& sdf, Diagnostics& diagnostics) const {
  Diagnostics found;
  std::shared_ptr<const description::Model> model = queue_.edits().read(sdf, owner_.isFromOutside(), found);
  throwFirst(found, sdf.position, diagnostics);
  return ModelTemplate(std::move(model));
}

ModelTemplate WorldEdits::readText(std::string_view text, std::string_view name, Diagnostics& diagnostics) const {
  Diagnostics found;
  std::shared_ptr<const description::Model> model = queue_.edits().readText(text, name, found);
  throwFirst(found, {std::make_shared<const std::string>(name), 0, 0}, diagnostics);
  if (auto* notes = owner_.notes()) notes->keepSource(model, {false, std::string(text), std::string(name)});
  return ModelTemplate(std::move(model));
}

ModelTemplate WorldEdits::readFile(const std::filesystem::path& file, Diagnostics& diagnostics) const {
  Diagnostics found;
  std::shared_ptr<const description::Model> model = queue_.edits().readFile(file, found);
  throwFirst(found, {std::make_shared<const std::string>(file.string()), 0, 0}, diagnostics);
  if (auto* notes = owner_.notes()) notes->keepSource(model, {true, file.string(), {}});
  return ModelTemplate(std::move(model));
}

std::vector<std::filesystem::path> WorldEdits::resourceFolders() const { return queue_.edits().places().folders; }

bool WorldEdits::isInReach(const std::filesystem::path& path) const { return queue_.edits().isInReach(path); }

/// A model inserted by a system that is from outside is from outside, too.
InsertOptions WorldEdits::owned(InsertOptions options) const {
  options.isFromOutside = options.isFromOutside || owner_.isFromOutside();
  return options;
}

std::optional<std::filesystem::path> WorldEdits::resolve(const std::string& address) const {
  Diagnostics none;
  return assets::finderIn(queue_.edits().places())(address, {}, {}, none);
}

void WorldEdits::insert(const ModelTemplate& model, const InsertOptions& options, Inserted inserted) {
  if (auto* notes = owner_.notes()) noteInsertion(owner_, *notes, notes->sourceOf(model.model_), owned(options));
  queue_.insert(
      owner_,
      [model = model.model_, options = owned(options)](sim::ModelEdits& edits, Diagnostics& diagnostics) {
        return edits.insert(*model, options, diagnostics);
      },
      std::move(inserted));
}

void WorldEdits::insertText(std::string text, std::string name, const InsertOptions& options, Inserted inserted) {
  if (auto* notes = owner_.notes()) {
    const sim::OutsideChange::Source source{false, text, name};
    noteInsertion(owner_, *notes, &source, owned(options));
  }
  queue_.insert(
      owner_,
      [text = std::move(text), name = std::move(name), options = owned(options)](sim::ModelEdits& edits,
                                                                                 Diagnostics& diagnostics) {
        return edits.insertText(text, name, options, diagnostics);
      },
      std::move(inserted));
}

void WorldEdits::insertFile(std::filesystem::path file, const InsertOptions& options, Inserted inserted) {
  if (auto* notes = owner_.notes()) {
    const sim::OutsideChange::Source source{true, file.string(), {}};
    noteInsertion(owner_, *notes, &source, owned(options));
  }
  queue_.insert(
      owner_,
      [file = std::move(file), options = owned(options)](sim::ModelEdits& edits, Diagnostics& diagnostics) {
        return edits.insertFile(file, options, diagnostics);
      },
      std::move(inserted));
}

void WorldEdits::insertCopy(const Model& model, const InsertOptions& options, Inserted inserted) {
  if (auto* notes = owner_.notes()) noteInsertion(owner_, *notes, nullptr, owned(options));
  queue_.insert(
      owner_,
      [original = model.id(), options = owned(options)](sim::ModelEdits& edits, Diagnostics& diagnostics) {
        return edits.insertCopy(original, options, diagnostics);
      },
      std::move(inserted));
}

void WorldEdits::remove(const Model& model, Removed removed) {
  owner_.note({.kind = sim::OutsideChange::Kind::kRemove, .id = model.id().value});
  queue_.remove(owner_, model.id(), std::move(removed));
}

}  // namespace pongsim
