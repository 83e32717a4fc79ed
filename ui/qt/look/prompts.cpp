// SPDX-License-Identifier: GPL-3.0-or-later
#include "prompts.hpp"

#include <fmt/core.h>

#include <QAbstractFileIconProvider>
#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>
#include <QGridLayout>
#include <QGuiApplication>
#include <QHeaderView>
#include <QInputDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QSplitter>
#include <QStringList>
#include <QTreeView>
#include <QUrl>

#include "icons.hpp"
#include "screen_fit.hpp"
#include "user_files.hpp"

namespace hitos::window {
namespace {

QString prompt(const char* text) {
    return QCoreApplication::translate("Prompts", text);
}

/// "txt", "map" of "Maps (*.txt *.map)".
QStringList endings_of(const QString& filter) {
    static const QRegularExpression pattern(R"(\*\.(\w+))");
    QStringList endings;
    for (auto match = pattern.globalMatch(filter); match.hasNext();) {
        endings.push_back(match.next().captured(1));
    }
    return endings;
}

/// Looks at names alone: Qt's own opens files to tell their kind, which in some folders never ends.
class FilesByName final : public QAbstractFileIconProvider {
  public:
    QIcon icon(IconType type) const override {
        return hitos::window::icon(type == File       ? Glyph::file
                                   : type == Computer ? Glyph::computer
                                                      : Glyph::open);
    }
    QIcon icon(const QFileInfo& info) const override { return icon(info.isDir() ? Folder : File); }
    QString type(const QFileInfo& info) const override {
        return info.isDir() ? prompt(QT_TRANSLATE_NOOP("Prompts", "Folder"))
                            : info.suffix().toUpper();
    }
};

/// Where the desktop has none of its own it is wide enough for whole names. What it keeps is shared
/// by all programs with Qt, and stays as it was.
class OwnFileDialog : public QFileDialog {
  public:
    /// `start` is a folder, or the file to begin with.
    OwnFileDialog(QWidget* parent, const QString& title, const QString& start,
                  const QString& filters = {})
        : QFileDialog(parent, title, QDir::rootPath(), filters),
          list_(findChild<QTreeView*>("treeView")),
          halves_(findChild<QSplitter*>("splitter")) {
        static FilesByName by_name;
        constexpr QSize kWide(860, 520);
        setIconProvider(&by_name);  // before it looks into the folder
        const QFileInfo at(start);
        setDirectory(at.isDir() ? start : at.absolutePath());
        if (list_ == nullptr || halves_ == nullptr) return;
        columns_ = list_->header()->saveState();
        widths_ = halves_->saveState();
        list_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
        list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
        halves_->setSizes({kWide.width() / 5, kWide.width()});
        resize(size().expandedTo(kWide));
        fit_to_screen(*this);
    }

    /// Empty where the user cancelled.
    QString ask() {
        QString named = exec() == Accepted ? selectedFiles().value(0) : QString();
        if (list_ != nullptr && halves_ != nullptr) {
            list_->header()->restoreState(columns_);
            halves_->restoreState(widths_);
        }
        return named;
    }

  private:
    QTreeView* list_;
    QSplitter* halves_;
    QByteArray columns_;
    QByteArray widths_;
};

/// Of a box with that title: the desktop adds the program's name and buttons.
int width_of_title(const QDialog& box) {
    constexpr int kButtons = 120;
    const QString title = box.windowTitle() + " — " + QGuiApplication::applicationDisplayName();
    return box.fontMetrics().horizontalAdvance(title) + kButtons;
}

/// Of plain text: what a file is called is no markup.
int answer_to(QMessageBox& box) {
    box.setTextFormat(Qt::PlainText);
    auto* grid = qobject_cast<QGridLayout*>(box.layout());
    grid->addItem(new QSpacerItem(width_of_title(box), 0), grid->rowCount(), 0, 1,
                  grid->columnCount());
    return box.exec();
}

/// Asks for what is to be written or chosen; false where the user cancelled.
bool answers(QInputDialog& box, const QString& title, const QString& text) {
    box.setWindowTitle(title);
    box.setLabelText(text);
    box.minimumSizeHint();  // makes its layout
    box.layout()->addItem(new QSpacerItem(width_of_title(box), 0));
    return box.exec() == QDialog::Accepted;
}

/// Asks for the name of a folder to write: that of one that is there is taken too, where the usual
/// dialog would walk into it.
class FolderNameDialog final : public OwnFileDialog {
  public:
    FolderNameDialog(QWidget* parent, const QString& title, const QString& folder)
        : OwnFileDialog(parent, title, folder) {
        setOption(QFileDialog::DontUseNativeDialog);
        setOption(QFileDialog::DontConfirmOverwrite);
        setAcceptMode(QFileDialog::AcceptSave);
        setFileMode(QFileDialog::AnyFile);
    }

  protected:
    void accept() override {
        const QString named = selectedFiles().value(0);
        const auto* typed = findChild<QLineEdit*>("fileNameEdit");
        const bool walks =
            typed != nullptr && (typed->text().endsWith('/') || typed->text().endsWith(".."));
        if (!walks && QFileInfo(named).isDir() && named != directory().absolutePath()) {
            done(Accepted);
        } else {
            QFileDialog::accept();
        }
    }
};

}  // namespace

void NobodyThere::warn(QWidget* /*parent*/, const QString& title, const QString& text) {
    fmt::print(stderr, "hitos: {}: {}\n", title.toStdString(), text.toStdString());
    warned_ = true;
}

QString with_ending(const QString& path, const QString& chosen, const QString& otherwise) {
    if (!QFileInfo(path).suffix().isEmpty()) return path;
    const QStringList wanted = endings_of(chosen);
    const QString added = wanted.isEmpty() ? otherwise : wanted.front();
    return added.isEmpty() ? path : path + '.' + added;
}

QString QtPrompts::open_file(QWidget* parent, const FileQuestion& question) {
    OwnFileDialog dialog(parent, question.title, question.start, question.filters);
    dialog.setFileMode(QFileDialog::ExistingFile);
    const QFileInfo start(question.start);
    if (!start.isDir()) dialog.selectFile(start.fileName());
    // What comes with Hitos is a click away, wherever the last file was.
    QList<QUrl> shipped;
    for (const char* kind : {"config", "log", "map"}) {
        const QString place = shipped_folder(kind);
        if (!place.isEmpty()) shipped << QUrl::fromLocalFile(place);
    }
    const auto of_the_user = [&] {
        QList<QUrl> places = dialog.sidebarUrls();
        places.removeIf([&shipped](const QUrl& place) { return shipped.contains(place); });
        return places;
    };
    dialog.setSidebarUrls(of_the_user() + shipped);
    QString named = dialog.ask();
    dialog.setSidebarUrls(of_the_user());
    return named;
}

QString QtPrompts::save_file(QWidget* parent, const FileQuestion& question) {
    const QFileInfo start(question.start);
    if (question.folder) {
        FolderNameDialog dialog(parent, question.title, start.absolutePath());
        dialog.selectFile(start.fileName());
        return dialog.ask();
    }
    OwnFileDialog dialog(parent, question.title, start.absolutePath(), question.filters);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setFileMode(QFileDialog::AnyFile);
    // Whether a file may be replaced is asked by the caller, the same way everywhere.
    dialog.setOption(QFileDialog::DontConfirmOverwrite);
    dialog.selectFile(start.fileName());
    const QString path = dialog.ask();
    const QString filter = dialog.selectedNameFilter();
    if (question.chosen != nullptr) *question.chosen = filter;
    return path.isEmpty() ? path : with_ending(path, filter, question.suffix);
}

QString QtPrompts::choose_folder(QWidget* parent, const QString& title, const QString& start) {
    OwnFileDialog dialog(parent, title, start);
    dialog.setFileMode(QFileDialog::Directory);
    dialog.setOption(QFileDialog::ShowDirsOnly);
    return dialog.ask();
}

bool QtPrompts::confirm(QWidget* parent, const Question& question) {
    QMessageBox box(QMessageBox::Question, question.title, question.text, QMessageBox::Cancel,
                    parent);
    box.setInformativeText(question.details);
    QPushButton* accept = box.addButton(question.accept, QMessageBox::AcceptRole);
    box.setDefaultButton(
        question.loses ? qobject_cast<QPushButton*>(box.button(QMessageBox::Cancel)) : accept);
    answer_to(box);
    return box.clickedButton() == accept;
}

std::optional<int> QtPrompts::number(QWidget* parent, const QString& title, const QString& text,
                                     int least, int greatest) {
    QInputDialog box(parent);
    box.setInputMode(QInputDialog::IntInput);
    box.setIntRange(least, greatest);
    box.setIntValue(least);
    return answers(box, title, text) ? std::optional(box.intValue()) : std::nullopt;
}

std::optional<int> QtPrompts::choice(QWidget* parent, const QString& title, const QString& text,
                                     const QStringList& words, int first) {
    QInputDialog box(parent);
    box.setComboBoxItems(words);
    box.setTextValue(words.value(first));
    if (!answers(box, title, text)) return std::nullopt;
    return static_cast<int>(words.indexOf(box.textValue()));
}

std::optional<QString> QtPrompts::text(QWidget* parent, const QString& title, const QString& text) {
    QInputDialog box(parent);
    return answers(box, title, text) ? std::optional(box.textValue()) : std::nullopt;
}

void QtPrompts::warn(QWidget* parent, const QString& title, const QString& text) {
    QMessageBox box(QMessageBox::Warning, title, text, QMessageBox::Ok, parent);
    answer_to(box);
}

bool may_overwrite(Prompts& prompts, QWidget* parent, const QString& path) {
    const QString name = QFileInfo(path).fileName();
    if (QFileInfo(path).isDir()) {
        if (QDir(path).isEmpty()) return true;
        return prompts.confirm(
            parent,
            {prompt(QT_TRANSLATE_NOOP("Prompts", "The folder exists")),
             prompt(QT_TRANSLATE_NOOP("Prompts", "Write into %1?")).arg(name),
             prompt(QT_TRANSLATE_NOOP("Prompts",
                                      "Results of another run in it will be lost; other files "
                                      "stay.")),
             prompt(QT_TRANSLATE_NOOP("Prompts", "Replace")), true});
    }
    return prompts.confirm(parent,
                           {prompt(QT_TRANSLATE_NOOP("Prompts", "The file exists")),
                            prompt(QT_TRANSLATE_NOOP("Prompts", "Replace %1?")).arg(name),
                            prompt(QT_TRANSLATE_NOOP("Prompts", "What it holds now will be lost.")),
                            prompt(QT_TRANSLATE_NOOP("Prompts", "Replace")), true});
}

QString ask_where_to_save(Prompts& prompts, QWidget* parent, Prompts::FileQuestion question) {
    for (;;) {
        QString path = prompts.save_file(parent, question);
        if (path.isEmpty()) return {};
        const bool in_the_way = question.folder && QFileInfo(path).isFile();
        if (in_the_way) {
            prompts.warn(parent, question.title,
                         prompt(QT_TRANSLATE_NOOP("Prompts",
                                                  "%1 is a file, and a folder is to be written. "
                                                  "Choose another name."))
                             .arg(QFileInfo(path).fileName()));
        } else if (!QFileInfo::exists(path) || may_overwrite(prompts, parent, path)) {
            return path;
        }
        question.start = path;
    }
}

void tell_not_written(Prompts& prompts, QWidget* parent, const QString& reason) {
    prompts.warn(parent, prompt(QT_TRANSLATE_NOOP("Prompts", "The file was not written")), reason);
}

}  // namespace hitos::window
