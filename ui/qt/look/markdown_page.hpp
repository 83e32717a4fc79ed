// SPDX-License-Identifier: GPL-3.0-or-later
// A page of Markdown as the window shows it: the guide, the lessons.
#pragma once

#include <QAbstractTextDocumentLayout>
#include <QTextBrowser>
#include <QVector>
#include <functional>
#include <utility>

namespace hitos::window {

/// Pictures are never wider than the page, tables and code are set apart, all in the colours of the
/// theme. Every heading is an anchor, under the name that GitHub gives it; one of a page in a
/// folder of translations ("docs/es") under that of its original's too, which is the heading of the
/// same number of the file of the same name in the folder above.
class MarkdownPage final : public QTextBrowser, public QTextObjectInterface {
    Q_OBJECT
    Q_INTERFACES(QTextObjectInterface)

  public:
    struct Heading {
        int level = 0;  ///< 1: the title of the page
        int position = 0;
        QString title;
        QStringList anchors;
    };

    explicit MarkdownPage(QWidget* parent);
    const QVector<Heading>& headings() const { return headings_; }
    /// Changes the text of each page before it is shown.
    void set_rewriting(std::function<QString(const QString&)> rewrite) {
        rewrite_ = std::move(rewrite);
    }
    /// The index of the heading that the top of the page stands under; -1 before the first.
    int heading_in_sight() const;

    QVariant loadResource(int type, const QUrl& name) override;
    // Pictures: as wide as they are, and smoothly narrower where the page is.
    QSizeF intrinsicSize(QTextDocument* document, int position, const QTextFormat& format) override;
    void drawObject(QPainter* painter, const QRectF& place, QTextDocument* document, int position,
                    const QTextFormat& format) override;

  protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    void complete(const QUrl& url);
    void read_headings();
    void dress();

    QVector<Heading> headings_;
    std::function<QString(const QString&)> rewrite_;
    QUrl page_;  ///< the file that was loaded last
    bool dressed_ = false;
};

}  // namespace hitos::window
