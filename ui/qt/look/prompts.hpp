// SPDX-License-Identifier: GPL-3.0-or-later
// Questions to the user, behind one face so that tests can answer them.
#pragma once

#include <QFileInfo>
#include <QString>
#include <QStringList>
#include <exception>
#include <optional>

#include "words_of.hpp"

class QWidget;

namespace hitos::window {

class Prompts {
  public:
    struct FileQuestion {
        QString title;
        QString start;              ///< folder or file to begin with
        QString filters;            ///< as QFileDialog takes them
        QString suffix;             ///< added to a name without one where the filter names none
        bool folder = false;        ///< what is written is a folder
        QString* chosen = nullptr;  ///< takes the filter under which a file to write was named
    };
    struct Question {
        QString title;
        QString text;
        QString details;     ///< shown below, smaller
        QString accept;      ///< the button's words
        bool loses = false;  ///< something cannot be had back: Return alone does not accept
    };

    virtual ~Prompts() = default;
    /// The file to read; empty where the user cancelled.
    virtual QString open_file(QWidget* parent, const FileQuestion& question) = 0;
    /// The file to write, whether it exists or not; empty where the user cancelled.
    virtual QString save_file(QWidget* parent, const FileQuestion& question) = 0;
    /// A folder, which may be new; empty where the user cancelled.
    virtual QString choose_folder(QWidget* parent, const QString& title, const QString& start) = 0;
    virtual bool confirm(QWidget* parent, const Question& question) = 0;
    /// A whole number from `least` to `greatest`; nothing where the user cancelled.
    virtual std::optional<int> number(QWidget* parent, const QString& title, const QString& text,
                                      int least, int greatest) = 0;
    /// Which of the words, by its place, where the one at `first` stands chosen; nothing where the
    /// user cancelled.
    virtual std::optional<int> choice(QWidget* parent, const QString& title, const QString& text,
                                      const QStringList& words, int first) = 0;
    /// A word or two; nothing where the user cancelled.
    virtual std::optional<QString> text(QWidget* parent, const QString& title,
                                        const QString& text) = 0;
    virtual void warn(QWidget* parent, const QString& title, const QString& text) = 0;
};

/// The real questions.
class QtPrompts final : public Prompts {
  public:
    QString open_file(QWidget* parent, const FileQuestion& question) override;
    QString save_file(QWidget* parent, const FileQuestion& question) override;
    QString choose_folder(QWidget* parent, const QString& title, const QString& start) override;
    bool confirm(QWidget* parent, const Question& question) override;
    std::optional<int> number(QWidget* parent, const QString& title, const QString& text, int least,
                              int greatest) override;
    std::optional<int> choice(QWidget* parent, const QString& title, const QString& text,
                              const QStringList& words, int first) override;
    std::optional<QString> text(QWidget* parent, const QString& title,
                                const QString& text) override;
    void warn(QWidget* parent, const QString& title, const QString& text) override;
};

/// Where nobody can answer: what a dialog would warn of goes to stderr.
class NobodyThere final : public Prompts {
  public:
    QString open_file(QWidget*, const FileQuestion&) override { return {}; }
    QString save_file(QWidget*, const FileQuestion&) override { return {}; }
    QString choose_folder(QWidget*, const QString&, const QString&) override { return {}; }
    bool confirm(QWidget*, const Question&) override { return false; }
    std::optional<int> number(QWidget*, const QString&, const QString&, int, int) override {
        return std::nullopt;
    }
    std::optional<int> choice(QWidget*, const QString&, const QString&, const QStringList&,
                              int) override {
        return std::nullopt;
    }
    std::optional<QString> text(QWidget*, const QString&, const QString&) override {
        return std::nullopt;
    }
    void warn(QWidget* parent, const QString& title, const QString& text) override;
    bool warned() const { return warned_; }

  private:
    bool warned_ = false;
};

/// The path; where its name has no ending, with the one that the chosen filter asks for ("Drawings
/// (*.dxf)"), or `otherwise` where the filter names none. An ending that was typed stays: it says
/// what is written.
QString with_ending(const QString& path, const QString& chosen, const QString& otherwise);

/// Whether the user lets an existing file, or the results in an existing folder, be replaced.
bool may_overwrite(Prompts& prompts, QWidget* parent, const QString& path);
void tell_not_written(Prompts& prompts, QWidget* parent, const QString& reason);

/// Asks where to write until the user names a new file, lets the old one be replaced, or gives up
/// (empty).
QString ask_where_to_save(Prompts& prompts, QWidget* parent, Prompts::FileQuestion question);

/// Asks for a file to write until it is written or the user gives up: asks before it overwrites,
/// and where `write` throws hitos::Error it says why and asks again [T 8.2.2.3, 8.2.2.9, 8.2.2.10].
/// Returns the path written, empty where the user gave up.
template <class Write>
QString save_until_done(Prompts& prompts, QWidget* parent, Prompts::FileQuestion question,
                        Write write) {
    for (;;) {
        QString path = ask_where_to_save(prompts, parent, question);
        if (path.isEmpty()) return {};
        question.start = path;
        try {
            write(path);
            return path;
        } catch (const std::exception& error) {
            tell_not_written(prompts, parent, words_of(error));
        }
    }
}

}  // namespace hitos::window
