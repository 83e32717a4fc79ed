// SPDX-License-Identifier: GPL-3.0-or-later
#include "guide_window.hpp"

#include <QAction>
#include <QDesktopServices>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QScrollBar>
#include <QSettings>
#include <QShortcut>
#include <QSignalBlocker>
#include <QSplitter>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "look/markdown_page.hpp"
#include "look/named.hpp"
#include "look/screen_fit.hpp"
#include "look/theme.hpp"

namespace hitos::window {
namespace {

constexpr QSize kGuideSize(1060, 720);
constexpr const char* kGeometryKey = "guide/geometry";
constexpr const char* kHalvesKey = "guide/contents";

/// Letters without case and accents, one for one.
QString plain_letters(QString text) {
    for (QChar& letter : text) {
        const QString parts = letter.decomposition();
        if (!parts.isEmpty()) letter = parts.front();
        letter = letter.toLower();
    }
    return text;
}

}  // namespace

GuideWindow::GuideWindow(QSettings& settings, QString language, QWidget* parent)
    : QDialog(parent, Qt::Window),
      settings_(settings),
      language_(std::move(language)),
      page_(new MarkdownPage(this)),
      contents_(new QListWidget(this)),
      halves_(new QSplitter(this)),
      search_(new QLineEdit(this)),
      found_(new QLabel(this)) {
    setObjectName("guide_window");
    setWindowTitle(tr("User's guide"));
    page_->setObjectName("guide_page");
    page_->setAccessibleName(tr("Page"));
    page_->setOpenLinks(false);
    contents_->setObjectName("guide_contents");
    contents_->setAccessibleName(tr("Contents"));
    contents_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* column = new QVBoxLayout(this);
    column->addLayout(make_tools());
    halves_->addWidget(contents_);
    halves_->addWidget(page_);
    halves_->setStretchFactor(1, 1);
    halves_->setChildrenCollapsible(false);
    column->addWidget(halves_, 1);
    connect(page_, &QTextBrowser::anchorClicked, this, &GuideWindow::follow);
    connect(page_, &QTextBrowser::sourceChanged, this, &GuideWindow::show_headings);
    connect(page_->verticalScrollBar(), &QScrollBar::valueChanged, this,
            &GuideWindow::mark_heading);
    connect(contents_, &QListWidget::currentRowChanged, this, [this](int row) {
        if (row < 0) return;
        QUrl place = page_->source();
        place.setFragment(page_->headings()[row].anchors.value(0));
        page_->setSource(place);
        // On its way the page may have stood under the heading before.
        const QSignalBlocker quiet(contents_);
        contents_->setCurrentRow(row);
    });
    constexpr int kContentsWidth = 240;
    halves_->setSizes({kContentsWidth, kGuideSize.width() - kContentsWidth});
    halves_->restoreState(settings.value(kHalvesKey).toByteArray());
    resize(kGuideSize);
    fit_to_screen(*this);
    if (restoreGeometry(settings.value(kGeometryKey).toByteArray()))
        keep_on_screen(*this);
    else
        place_beside_parent(*this, kBeside);
    page_->setFocus();
}

GuideWindow::~GuideWindow() {
    settings_.setValue(kGeometryKey, saveGeometry());
    settings_.setValue(kHalvesKey, halves_->saveState());
}

QLayout* GuideWindow::make_tools() {
    auto* row = new QHBoxLayout;
    const auto add = [&](const QString& words, Qt::ArrowType arrow, QKeySequence::StandardKey key,
                         const char* name) {
        auto* button = named(new QToolButton(this), name);
        button->setArrowType(arrow);
        button->setAccessibleName(words);
        button->setToolTip(words + " (" + QKeySequence(key).toString(QKeySequence::NativeText) +
                           ')');
        button->setShortcut(key);
        button->setEnabled(false);
        row->addWidget(button);
        return button;
    };
    QToolButton* back = add(tr("Back"), Qt::LeftArrow, QKeySequence::Back, "guide_back");
    QToolButton* forward =
        add(tr("Forward"), Qt::RightArrow, QKeySequence::Forward, "guide_forward");
    connect(back, &QToolButton::clicked, page_, &QTextBrowser::backward);
    connect(forward, &QToolButton::clicked, page_, &QTextBrowser::forward);
    connect(page_, &QTextBrowser::backwardAvailable, back, &QWidget::setEnabled);
    connect(page_, &QTextBrowser::forwardAvailable, forward, &QWidget::setEnabled);
    search_->setObjectName("guide_search");
    search_->setPlaceholderText(tr("Search this page (Ctrl+F)"));
    search_->setAccessibleName(tr("Search"));
    search_->setToolTip(tr("Return goes to the next place, Shift+Return to the one before"));
    search_->setClearButtonEnabled(true);
    row->addWidget(search_, 1);
    found_->setObjectName("guide_found");
    row->addWidget(found_);
    connect(search_, &QLineEdit::textChanged, this, &GuideWindow::search);
    connect(new QShortcut(QKeySequence::Find, this), &QShortcut::activated, search_, [this] {
        search_->setFocus();
        search_->selectAll();
    });
    // The field alone has these keys: links take Return too.
    const auto step = [this](const QList<QKeySequence>& keys, qsizetype by) {
        auto* action = new QAction(search_);
        action->setShortcuts(keys);
        action->setShortcutContext(Qt::WidgetShortcut);
        search_->addAction(action);
        connect(action, &QAction::triggered, this, [this, by] {
            if (!hits_.isEmpty()) go_to_hit((hit_ + by + hits_.size()) % hits_.size());
        });
    };
    step({Qt::Key_Return, Qt::Key_Enter}, 1);
    step({Qt::SHIFT | Qt::Key_Return, Qt::SHIFT | Qt::Key_Enter}, -1);
    return row;
}

QString GuideWindow::translated(const QString& path) const {
    const QFileInfo file(path);
    const QString other = file.path() + '/' + language_ + '/' + file.fileName();
    return QFileInfo::exists(other) ? other : path;
}

void GuideWindow::go_to(const QString& path, const QString& heading) {
    QUrl place = QUrl::fromLocalFile(translated(path));
    place.setFragment(heading);
    page_->setSource(place, QTextDocument::MarkdownResource);
}

void GuideWindow::follow(const QUrl& link) {
    const QUrl target = page_->source().resolved(link);
    const QFileInfo file(target.toLocalFile());
    if (!target.isLocalFile() || file.suffix() != "md") {
        QDesktopServices::openUrl(target);
    } else if (file.exists()) {
        go_to(file.absoluteFilePath(), target.fragment());
    } else {
        found_->setText(tr("%1 is not installed.").arg(file.fileName()));
    }
}

void GuideWindow::show_headings() {
    const QSignalBlocker quiet(contents_);
    contents_->clear();
    for (const MarkdownPage::Heading& heading : page_->headings()) {
        constexpr qsizetype kIndent = 3;
        contents_->addItem(QString(kIndent * std::max(0, heading.level - 2), ' ') + heading.title);
        contents_->item(contents_->count() - 1)->setToolTip(heading.title);
    }
    find_all();
    mark_hits();
    mark_heading();
}

/// The heading that the page stands under; one that was chosen stays so while it is in sight, as
/// those of the last page are that cannot come to the top.
void GuideWindow::mark_heading() {
    const QScrollBar& bar = *page_->verticalScrollBar();
    const int chosen = contents_->currentRow();
    const int top = page_->heading_in_sight();
    if (bar.value() == bar.maximum() && chosen > top) return;
    const QSignalBlocker quiet(contents_);
    contents_->setCurrentRow(top);
}

/// As it is typed: goes to the first place from the one before on, or from what is in sight on.
void GuideWindow::search() {
    const int here = hit_ >= 0 ? hits_[hit_] : page_->cursorForPosition(QPoint()).position();
    find_all();
    const auto next = std::ranges::lower_bound(hits_, here);
    if (!hits_.isEmpty()) go_to_hit((next - hits_.begin()) % hits_.size());
    mark_hits();
}

void GuideWindow::find_all() {
    hits_.clear();
    hit_ = -1;
    const QString wanted = plain_letters(search_->text());
    if (wanted.isEmpty()) return;
    const QString text = plain_letters(page_->document()->toPlainText());
    for (qsizetype at = text.indexOf(wanted); at >= 0;
         at = text.indexOf(wanted, at + wanted.size()))
        hits_ << static_cast<int>(at);
}

void GuideWindow::go_to_hit(qsizetype hit) {
    hit_ = hit;
    QTextCursor cursor(page_->document());
    cursor.setPosition(hits_[hit]);
    page_->setTextCursor(cursor);
    page_->ensureCursorVisible();
    mark_hits();
}

void GuideWindow::mark_hits() {
    QList<QTextEdit::ExtraSelection> marks;
    const auto length = static_cast<int>(search_->text().size());
    for (qsizetype i = 0; i < hits_.size(); ++i) {
        QTextEdit::ExtraSelection mark{QTextCursor(page_->document()), {}};
        mark.cursor.setPosition(hits_[i]);
        mark.cursor.setPosition(hits_[i] + length, QTextCursor::KeepAnchor);
        QColor behind = colours().particle;
        constexpr int kPale = 90;
        if (i != hit_) behind.setAlpha(kPale);
        mark.format.setBackground(behind);
        if (i == hit_) mark.format.setForeground(colours().on_accent);
        marks << mark;
    }
    page_->setExtraSelections(marks);
    const bool wrong = hits_.isEmpty() && !search_->text().isEmpty();
    set_look(*search_, "state", wrong ? "wrong" : "");
    found_->setText(search_->text().isEmpty() ? QString()
                    : hits_.isEmpty()         ? tr("not found")
                    : hit_ < 0                ? tr("found: %1").arg(hits_.size())
                                              : tr("%1 of %2").arg(hit_ + 1).arg(hits_.size()));
}

}  // namespace hitos::window
