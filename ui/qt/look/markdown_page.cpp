// SPDX-License-Identifier: GPL-3.0-or-later
#include "markdown_page.hpp"

#include <QEvent>
#include <QFile>
#include <QFileInfo>
#include <QPainter>
#include <QPixmap>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextTable>
#include <algorithm>
#include <utility>

#include "theme.hpp"

namespace hitos::window {
namespace {

constexpr double kCellPadding = 5.0;  // pixels, in the cells of a table
constexpr double kPageMargin = 10.0;

QPixmap pixmap_of(const QTextDocument& document, const QTextFormat& format) {
    const QUrl name(format.toImageFormat().name());
    return document.resource(QTextDocument::ImageResource, name).value<QPixmap>();
}

/// The names that GitHub gives the headings of a file, in their order; none where it is not there.
QStringList anchors_of(const QString& path) {
    QStringList anchors;
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly | QIODevice::Text)) return anchors;
    static const QRegularExpression heading("^#{1,6}\\s+(.*)$");
    static const QRegularExpression dropped("[^\\w\\- ]",
                                            QRegularExpression::UseUnicodePropertiesOption);
    bool fenced = false;
    for (const QString& line : QString::fromUtf8(file.readAll()).split('\n')) {
        if (line.startsWith("```")) fenced = !fenced;
        const QRegularExpressionMatch match = heading.match(line);
        if (fenced || !match.hasMatch()) continue;
        anchors << match.captured(1).trimmed().toLower().remove(dropped).replace(' ', '-');
    }
    return anchors;
}

}  // namespace

MarkdownPage::MarkdownPage(QWidget* parent) : QTextBrowser(parent) {
    document()->documentLayout()->registerHandler(QTextFormat::ImageObject, this);
    connect(this, &QTextBrowser::sourceChanged, this, &MarkdownPage::complete);
}

QSizeF MarkdownPage::intrinsicSize(QTextDocument* document, int /*position*/,
                                   const QTextFormat& format) {
    const QSizeF size = pixmap_of(*document, format).size();
    // In a list there is one indent less.
    const double around = 2.0 * document->documentMargin() + document->indentWidth();
    const double room = std::max(1.0, document->textWidth() - around);
    return size.width() > room ? size * (room / size.width()) : size;
}

void MarkdownPage::drawObject(QPainter* painter, const QRectF& place, QTextDocument* document,
                              int /*position*/, const QTextFormat& format) {
    painter->save();
    painter->setRenderHint(QPainter::SmoothPixmapTransform);
    const QPixmap picture = pixmap_of(*document, format);
    painter->drawPixmap(place, picture, picture.rect());
    painter->restore();
}

/// While a page is loaded source() is still the one before.
QVariant MarkdownPage::loadResource(int type, const QUrl& name) {
    if (type != QTextDocument::MarkdownResource) {
        return QTextBrowser::loadResource(type, page_.resolved(name));
    }
    page_ = name;
    dressed_ = false;
    QVariant content = QTextBrowser::loadResource(type, name);
    if (!rewrite_) return content;
    return rewrite_(QString::fromUtf8(content.toByteArray())).toUtf8();
}

/// The base class has loaded the page, and did not know its anchors when it went there.
void MarkdownPage::complete(const QUrl& url) {
    if (!std::exchange(dressed_, true)) {
        read_headings();
        dress();
    }
    scrollToAnchor(url.fragment());
}

void MarkdownPage::read_headings() {
    headings_.clear();
    const QFileInfo file(page_.toLocalFile());
    const QStringList own = anchors_of(file.filePath());
    const QStringList original = anchors_of(file.path() + "/../" + file.fileName());
    for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
        const int level = block.blockFormat().headingLevel();
        if (level == 0) continue;
        const auto number = headings_.size();
        headings_.append(
            {level, block.position(), block.text(), own.mid(number, 1) + original.mid(number, 1)});
    }
}

void MarkdownPage::dress() {
    QTextCursor cursor(document());
    cursor.beginEditBlock();
    for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
        if (!block.blockFormat().hasProperty(QTextFormat::BlockCodeFence)) continue;
        QTextBlockFormat code;
        code.setBackground(colours().window);
        code.setNonBreakableLines(false);  // a long command goes on in the next line
        cursor.setPosition(block.position());
        cursor.mergeBlockFormat(code);
    }
    for (QTextFrame* frame : document()->rootFrame()->childFrames()) {
        auto* table = qobject_cast<QTextTable*>(frame);
        if (table == nullptr) continue;
        QTextTableFormat format = table->format();
        format.setBorder(1.0);
        format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
        format.setBorderBrush(colours().border);
        format.setBorderCollapse(true);
        format.setCellPadding(kCellPadding);
        format.setTopMargin(kPageMargin);
        format.setBottomMargin(kPageMargin);
        table->setFormat(format);
    }
    for (const Heading& heading : headings_) {
        QTextCharFormat anchor;
        anchor.setAnchor(true);
        anchor.setAnchorNames(heading.anchors);
        cursor.setPosition(heading.position);
        QTextBlockFormat apart;
        apart.setTopMargin(2.0 * kPageMargin);
        if (heading.level > 1) cursor.mergeBlockFormat(apart);
        cursor.movePosition(QTextCursor::EndOfBlock, QTextCursor::KeepAnchor);
        cursor.mergeCharFormat(anchor);
    }
    cursor.endEditBlock();
    document()->setDocumentMargin(kPageMargin);
    document()->size();  // lays all of it out: what goes to a place now finds it
}

int MarkdownPage::heading_in_sight() const {
    constexpr int kAsGoodAsThere = 8;  // pixels; an anchor is not at the very top
    const int top = cursorForPosition(QPoint(0, kAsGoodAsThere)).position();
    const auto after = std::ranges::upper_bound(headings_, top, {}, &Heading::position);
    return static_cast<int>(after - headings_.begin()) - 1;
}

/// The pictures take the new width, before the base class sees how wide all of it is.
void MarkdownPage::resizeEvent(QResizeEvent* event) {
    document()->setTextWidth(viewport()->width());
    document()->size();
    QTextBrowser::resizeEvent(event);
}

/// Links and tables have the colours of the theme that they were made in.
void MarkdownPage::changeEvent(QEvent* event) {
    QTextBrowser::changeEvent(event);
    if (event->type() != QEvent::PaletteChange || !source().isValid()) return;
    const int place = verticalScrollBar()->value();
    reload();
    verticalScrollBar()->setValue(place);
}

}  // namespace hitos::window
