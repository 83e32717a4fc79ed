// SPDX-License-Identifier: GPL-3.0-or-later
// The user's guide, and what else of the documents it leads to.
#pragma once

#include <QDialog>
#include <QVector>

class QLabel;
class QLineEdit;
class QListWidget;
class QSettings;
class QSplitter;

namespace hitos::window {

class MarkdownPage;

/// A page with the list of its headings beside it and a field that searches it, whatever its
/// letters' case and accents. Links to other documents open here, in `language` where they are
/// translated (docs/es/NAME.md beside docs/NAME.md); all others on the desktop. Its size is
/// remembered in `settings`.
class GuideWindow final : public QDialog {
    Q_OBJECT

  public:
    GuideWindow(QSettings& settings, QString language, QWidget* parent);
    ~GuideWindow() override;

    /// A file of Markdown, which is there, at the heading of that name in the English page; empty:
    /// at its beginning.
    void go_to(const QString& path, const QString& heading);
    /// The file that is shown of it: a translation where there is one.
    QString translated(const QString& path) const;

  private:
    QLayout* make_tools();
    void follow(const QUrl& link);
    void show_headings();
    void mark_heading();
    void search();
    void find_all();
    void go_to_hit(qsizetype hit);
    void mark_hits();

    QSettings& settings_;
    QString language_;
    MarkdownPage* page_;
    QListWidget* contents_;
    QSplitter* halves_;
    QLineEdit* search_;
    QLabel* found_;
    QVector<int> hits_;   ///< where what is searched begins
    qsizetype hit_ = -1;  ///< the one that was gone to
};

}  // namespace hitos::window
