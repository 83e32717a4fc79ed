// SPDX-License-Identifier: GPL-3.0-or-later
#include "skipped_lines.hpp"

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QPlainTextEdit>
#include <QVBoxLayout>

#include "look/named.hpp"
#include "look/screen_fit.hpp"
#include "look/words_of.hpp"

namespace hitos::window {
namespace {

QString skipped_words(const char* text) {
    return QCoreApplication::translate("SkippedLines", text);
}

}  // namespace

void show_skipped_lines(QWidget* parent, const QString& file, const ReadReport& report) {
    QStringList lines;
    for (const ReadReport::Skip& skip : report.examples) {
        lines << words_of(report.placed(skip));
    }
    if (report.skipped > report.examples.size()) {
        lines << skipped_words(QT_TRANSLATE_NOOP("SkippedLines", "… and %1 more"))
                     .arg(report.skipped - report.examples.size());
    }
    auto* dialog = named(new QDialog(parent), "skipped_lines");
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    const char* title =
        report.of_recording
            ? QT_TRANSLATE_NOOP("SkippedLines", "Damaged messages and records of %1")
            : QT_TRANSLATE_NOOP("SkippedLines", "Damaged lines of %1");
    dialog->setWindowTitle(skipped_words(title).arg(QFileInfo(file).fileName()));
    auto* column = new QVBoxLayout(dialog);
    auto* text = new QPlainTextEdit(lines.join('\n'), dialog);
    text->setReadOnly(true);
    text->setTabChangesFocus(true);
    column->addWidget(text);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, dialog);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::close);
    column->addWidget(buttons);
    dialog->resize(560, 320);
    fit_to_screen(*dialog);
    dialog->show();
}

}  // namespace hitos::window
