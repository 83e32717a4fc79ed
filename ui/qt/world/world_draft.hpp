// SPDX-License-Identifier: GPL-3.0-or-later
// A world while it is drawn.
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "hitos/simulation/text/world_text.hpp"

namespace hitos::window {

/// The text of a world, what was done to it, and the file that it belongs to.
class WorldDraft final : public QObject {
    Q_OBJECT

  public:
    using Edit = std::function<void(WorldText&)>;

    explicit WorldDraft(QObject* parent);

    const WorldText& text() const { return *steps_[now_].text; }
    const World& world() const { return text().world(); }
    /// The file that it came from or was saved in last; empty: none yet.
    const QString& file() const { return steps_[now_].file; }
    /// Without folder and ending; "untitled" where it has no file.
    QString name() const;
    /// Something is not in the file.
    bool modified() const { return text().text() != saved_text(); }
    /// What the file holds, as far as the draft knows.
    const std::string& saved_text() const;
    /// Nothing was ever drawn or opened.
    bool untouched() const { return untouched_; }

    /// Another world; what was done before cannot be undone any more. Without a file it is one
    /// that is not saved yet.
    void open(WorldText text, const QString& file);
    /// The same world has another text and file now, as after a tour that was driven through it.
    void go_on_as(WorldText text, const QString& file);
    /// Does it, as one step; false, and nothing has changed, where it cannot be: refused() says
    /// why.
    bool change(const Edit& edit);
    /// Writes it; from then on what was done belongs to that file. Throws hitos::Error.
    void save(const QString& path);

    bool can_undo() const { return now_ > 0; }
    bool can_redo() const { return now_ + 1 < steps_.size(); }
    void undo();
    void redo();

  signals:
    void changed();
    /// Another world; changed() follows.
    void opened();
    /// It is as it was before or after a step; likewise.
    void stepped();
    void refused(QString reason);

  private:
    /// A driven tour may be kept in another file: undone, the drawing is that of its own again.
    struct Step {
        std::shared_ptr<const WorldText> text;
        QString file;
    };
    void add(WorldText text, const QString& file);
    void go_to(std::size_t step);

    std::vector<Step> steps_;  ///< never empty
    std::size_t now_ = 0;
    std::map<QString, std::string> saved_;  ///< what the files hold
    bool untouched_ = true;
};

}  // namespace hitos::window
