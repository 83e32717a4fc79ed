// SPDX-License-Identifier: GPL-3.0-or-later
#include "world_files.hpp"

#include <QDir>
#include <QFileInfo>
#include <QMenu>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/capture/tour_reader.hpp"
#include "hitos/workbench/shipped_data.hpp"
#include "hitos/workbench/world_import.hpp"
#include "import_dialog.hpp"
#include "look/words_of.hpp"
#include "world_draft.hpp"

namespace hitos::window {

WorldFiles::WorldFiles(WorldDraft& draft, UserFiles& files, Prompts& prompts, QWidget* window)
    : QObject(window), draft_(draft), files_(files), prompts_(prompts), window_(window) {}

void WorldFiles::fill(QMenu& menu) {
    const auto add = [&](const QString& text, const char* name, const QKeySequence& key, auto act) {
        QAction* action = menu.addAction(text, this, act);
        action->setObjectName(name);
        action->setShortcut(key);
        window_->addAction(action);  // its key works while the menu is closed
    };
    add(tr("&New"), "world_new", QKeySequence::New, [this] { start_new(); });
    add(tr("&Open…"), "world_open", QKeySequence::Open, [this] { ask_to_open(); });
    QMenu* shipped = menu.addMenu(tr("&Worlds that come with Hitos"));
    shipped->setObjectName("world_shipped");
    for (const std::string& name : shipped_worlds()) {
        QAction* action = shipped->addAction(QString::fromStdString(name));
        connect(action, &QAction::triggered, this, [this, name] {
            try {
                open(QString::fromStdString(find_world(name).string()));
            } catch (const std::exception& error) {
                prompts_.warn(window_, tr("The world cannot be opened"), words_of(error));
            }
        });
    }
    menu.addSeparator();
    add(tr("&Save"), "world_save", QKeySequence::Save, [this] { save(); });
    add(tr("Save &as…"), "world_save_as", QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S),
        [this] { save_as(); });
}

bool WorldFiles::may_discard() {
    emit asked_for();
    if (!draft_.modified()) return true;
    return prompts_.confirm(window_, {tr("The world is not saved"),
                                      tr("Give up what was drawn in %1?").arg(draft_.name()),
                                      tr("It will be lost."), tr("Give up"), true});
}

bool WorldFiles::start_new() {
    if (!may_discard()) return false;
    draft_.open(WorldText(), {});
    return true;
}

void WorldFiles::ask_to_open() {
    const QString path = prompts_.open_file(
        window_, {tr("World, drawing, map, picture or segments to open"),
                  files_.folder_to_open("world"),
                  tr("All of them (*.toml *.dxf *.map *.txt *.yaml *.yml *.png *.pgm *.jpg *.bmp);;"
                     "Worlds (*.toml);;Drawings (*.dxf);;Maps and segments (*.map *.txt);;"
                     "Occupancy pictures (*.yaml *.yml *.png *.pgm *.jpg *.jpeg *.bmp);;"
                     "All files (*)"),
                  {}});
    if (!path.isEmpty()) open(path);
}

bool WorldFiles::open(const QString& path) {
    if (!may_discard()) return false;
    try {
        if (is_world_file(path.toStdString())) {
            draft_.open(WorldText::read_unfinished(path.toStdString()), path);
        } else if (!import(path)) {
            return false;
        }
    } catch (const std::exception& error) {
        prompts_.warn(window_, tr("The world cannot be opened"), words_of(error));
        return false;
    }
    files_.note_opened("world", path);
    return true;
}

bool WorldFiles::import(const QString& path) {
    const WallSource kind = wall_source(path.toStdString());
    ImportDialog dialog(path, kind, window_);
    if (kind == WallSource::drawing || kind == WallSource::segments) {
        // Unit and layer are asked for where the drawing leaves a doubt.
        try {
            ImportReport report;
            const WorldText world = import_world(path.toStdString(), {}, {}, &report);
            if (report.warnings.empty()) {
                draft_.open(world, {});
                emit notice(found_words(world, report));
                return true;
            }
            dialog.tell(report.warnings);
        } catch (const FormatError& error) {
            const bool damaged = error.line() > 0;  // no choice mends that
            if (kind != WallSource::drawing || damaged) throw;
            dialog.tell({error.problem()});
        }
    }
    if (dialog.exec() != QDialog::Accepted || !dialog.world()) return false;
    draft_.open(*dialog.world(), {});
    emit notice(dialog.words());
    return true;
}

/// Somebody else may have written the file since it was opened.
bool WorldFiles::changed_by_others() const {
    if (!QFileInfo::exists(draft_.file())) return false;
    try {
        return input::read_text(draft_.file().toStdString()) != draft_.saved_text();
    } catch (const Error&) {
        return true;
    }
}

bool WorldFiles::save() {
    emit asked_for();
    if (draft_.file().isEmpty() || is_shipped(draft_.file())) return save_as();
    if (changed_by_others() && !may_overwrite(prompts_, window_, draft_.file())) return false;
    try {
        return write(draft_.file());
    } catch (const std::exception& error) {
        tell_not_written(prompts_, window_, words_of(error));
        return false;
    }
}

bool WorldFiles::save_as() {
    emit asked_for();
    const QString name = draft_.name() + QStringLiteral(".toml");
    const QString path = save_until_done(prompts_, window_,
                                         {tr("Save the world"), files_.place_to_save(name),
                                          tr("Worlds (*.toml)"), QStringLiteral("toml")},
                                         [this](const QString& file) { write(file); });
    if (path.isEmpty()) return false;
    files_.note_saved("world", path);
    files_.note_recent(path);
    return true;
}

bool WorldFiles::write(const QString& path) {
    check_world_name(path);
    draft_.save(path);
    emit notice(tr("The world is saved as %1").arg(path));
    return true;
}

QString WorldFiles::file_as_drawn() {
    emit asked_for();
    if (!draft_.file().isEmpty() && !draft_.modified() && !changed_by_others() &&
        QFileInfo::exists(draft_.file())) {
        return draft_.file();
    }
    // What was run of an earlier copy may be named by its results: another text is another file.
    const WorldText& text = draft_.text();
    if (copy_.isEmpty() || copied_ != text.text()) {
        copy_ = new_file_of_data(QStringLiteral("drawn"), draft_.name(), QStringLiteral("toml"));
        copied_ = text.text();
    }
    text.moved_to(copy_.toStdString()).save(copy_.toStdString());
    return copy_;
}

}  // namespace hitos::window
