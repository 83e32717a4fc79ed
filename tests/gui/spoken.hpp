// SPDX-License-Identifier: GPL-3.0-or-later
// A test in another language: what it says in English is read off the program's own translation, so
// that it is written once; and the guide's pictures, which there are in each.
#pragma once

#include <QHash>
#include <QList>
#include <QString>
#include <QStringList>
#include <utility>

class QWidget;

namespace hitos::window {

/// Rows "en" and "es" of the column "language".
void add_languages();

/// What is opened meanwhile speaks so; afterwards English again, as tests do.
class Spoken {
  public:
    explicit Spoken(const QString& language);
    ~Spoken();
    Spoken(const Spoken&) = delete;
    Spoken& operator=(const Spoken&) = delete;

    /// What the window may say for these English words, likeliest first; they may be the beginning
    /// of a sentence.
    QStringList said(const QString& words) const;
    /// Alt+F is of what F is marked in; the window above has another letter for the same.
    QString key(const QString& name) const;

  private:
    QStringList looked_up(const QString& words) const;
    QStringList in_sentences(const QString& words) const;

    mutable QHash<QString, QStringList> found_;
    QList<std::pair<QString, QString>> sentences_;  ///< English and other; & marks a letter
};

/// Into the folder HITOS_PICTURES where there is one, or the folder of the language in it.
bool keep_picture(QWidget& of, const QString& name);

}  // namespace hitos::window
