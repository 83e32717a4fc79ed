#include "world_draft.hpp"

#include <QFileInfo>
#include <utility>

#include "app/words_of.hpp"

namespace hitos::window {
namespace {

constexpr std::size_t kMostSteps = 300;

}  // namespace

WorldDraft::WorldDraft(QObject* parent)
    : QObject(parent), steps_{std::make_shared<const WorldText>()} {}

QString WorldDraft::name() const {
    return file_.isEmpty() ? tr("untitled") : QFileInfo(file_).completeBaseName();
}

bool WorldDraft::empty() const {
    return text().text().empty();
}

void WorldDraft::open(WorldText text, const QString& file) {
    file_ = file;
    saved_ = file.isEmpty() ? std::string() : text.text();
    steps_ = {std::make_shared<const WorldText>(std::move(text))};
    now_ = 0;
    emit opened();
    emit changed();
}

void WorldDraft::go_on_as(WorldText text, const QString& file) {
    file_ = file;
    saved_ = text.text();
    add(std::move(text));
}

void WorldDraft::add(WorldText text) {
    steps_.resize(now_ + 1);
    steps_.push_back(std::make_shared<const WorldText>(std::move(text)));
    if (steps_.size() > kMostSteps) steps_.erase(steps_.begin());
    now_ = steps_.size() - 1;
    emit changed();
}

bool WorldDraft::change(const Edit& edit) {
    WorldText next = text();
    try {
        edit(next);
    } catch (const std::exception& error) {
        emit refused(words_of(error));
        return false;
    }
    if (next.text() != text().text()) add(std::move(next));
    return true;
}

void WorldDraft::save(const QString& path) {
    auto next = std::make_shared<WorldText>(text());
    next->save(path.toStdString());
    file_ = path;
    saved_ = next->text();
    steps_[now_] = std::move(next);
    emit changed();
}

void WorldDraft::undo() {
    if (!can_undo()) return;
    --now_;
    emit changed();
}

void WorldDraft::redo() {
    if (!can_redo()) return;
    ++now_;
    emit changed();
}

}  // namespace hitos::window
