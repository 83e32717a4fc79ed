// SPDX-License-Identifier: GPL-3.0-or-later
#include "world_draft.hpp"

#include <QFileInfo>
#include <utility>

#include "hitos/base/error.hpp"
#include "look/words_of.hpp"

namespace hitos::window {
namespace {

constexpr std::size_t kMostSteps = 300;

}  // namespace

WorldDraft::WorldDraft(QObject* parent)
    : QObject(parent), steps_{{std::make_shared<const WorldText>(), {}}} {}

QString WorldDraft::name() const {
    return file().isEmpty() ? tr("untitled") : QFileInfo(file()).completeBaseName();
}

const std::string& WorldDraft::saved_text() const {
    static const std::string none;
    const auto found = saved_.find(file());
    return found == saved_.end() ? none : found->second;
}

void WorldDraft::open(WorldText text, const QString& file) {
    saved_.clear();
    if (!file.isEmpty()) saved_[file] = text.text();
    steps_ = {{std::make_shared<const WorldText>(std::move(text)), file}};
    now_ = 0;
    untouched_ = false;
    emit opened();
    emit changed();
}

void WorldDraft::go_on_as(WorldText text, const QString& file) {
    saved_[file] = text.text();
    add(std::move(text), file);
}

void WorldDraft::add(WorldText text, const QString& file) {
    steps_.resize(now_ + 1);
    steps_.push_back({std::make_shared<const WorldText>(std::move(text)), file});
    if (steps_.size() > kMostSteps) steps_.erase(steps_.begin());
    now_ = steps_.size() - 1;
    untouched_ = false;
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
    const QString same_file = file();
    if (next.text() != text().text()) add(std::move(next), same_file);
    return true;
}

void WorldDraft::save(const QString& path) {
    WorldText there = text().moved_to(path.toStdString());
    there.save(path.toStdString());
    saved_[path] = there.text();
    const QString before = file();
    for (std::size_t i = 0; i < steps_.size(); ++i) {
        if (i == now_) {
            steps_[i] = {std::make_shared<const WorldText>(there), path};
        } else if (steps_[i].file == before) {
            try {
                steps_[i] = {
                    std::make_shared<const WorldText>(steps_[i].text->moved_to(path.toStdString())),
                    path};
            } catch (const Error&) {  // its drawing is gone: it stays what it was
            }
        }
    }
    emit changed();
}

void WorldDraft::go_to(std::size_t step) {
    now_ = step;
    emit stepped();
    emit changed();
}

void WorldDraft::undo() {
    if (can_undo()) go_to(now_ - 1);
}

void WorldDraft::redo() {
    if (can_redo()) go_to(now_ + 1);
}

}  // namespace hitos::window
