#include "pongsim/world_edits.hh"

#include <utility>

#include "description/model.hh"
#include "sim/edit_queue.hh"

namespace pongsim {

const std::string& ModelTemplate::name() const { return model_->name; }

Pose ModelTemplate::pose() const { return model_->X_ParentModel; }

bool ModelTemplate::isStatic() const { return model_->isStatic; }

WorldEdits::~WorldEdits() = default;

ModelTemplate WorldEdits::read(const Element& sdf, Diagnostics& diagnostics) const {
  Diagnostics found;
  std::shared_ptr<const description::Model> model = queue_.edits().read(sdf, found);
  std::optional<Diagnostic> first;
  for (const Diagnostic& diagnostic : found.all()) {
    if (diagnostic.severity == Severity::kError && !first) {
      first = diagnostic;
      if (first->position.line == 0) first->position = sdf.position;
    } else {
      diagnostics.warning(diagnostic.position, diagnostic.message, diagnostic.hint);
    }
  }
  if (first) throw Error(*first);
  return ModelTemplate(std::move(model));
}

void WorldEdits::insert(const ModelTemplate& model, const InsertOptions& options, Inserted inserted) {
  queue_.insert(
      owner_,
      [model = model.model_, options](sim::ModelEdits& edits, Diagnostics& diagnostics) {
        return edits.insert(*model, options, diagnostics);
      },
      std::move(inserted));
}

void WorldEdits::insertText(std::string text, std::string name, const InsertOptions& options, Inserted inserted) {
  queue_.insert(
      owner_,
      [text = std::move(text), name = std::move(name), options](sim::ModelEdits& edits, Diagnostics& diagnostics) {
        return edits.insertText(text, name, options, diagnostics);
      },
      std::move(inserted));
}

void WorldEdits::insertFile(std::filesystem::path file, const InsertOptions& options, Inserted inserted) {
  queue_.insert(
      owner_,
      [file = std::move(file), options](sim::ModelEdits& edits, Diagnostics& diagnostics) {
        return edits.insertFile(file, options, diagnostics);
      },
      std::move(inserted));
}

void WorldEdits::insertCopy(const Model& model, const InsertOptions& options, Inserted inserted) {
  queue_.insert(
      owner_,
      [original = model.id(), options](sim::ModelEdits& edits, Diagnostics& diagnostics) {
        return edits.insertCopy(original, options, diagnostics);
      },
      std::move(inserted));
}

void WorldEdits::remove(const Model& model, Removed removed) { queue_.remove(owner_, model.id(), std::move(removed)); }

}  // namespace pongsim
