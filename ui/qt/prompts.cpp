#include "prompts.hpp"

#include <QCoreApplication>
#include <QFileDialog>
#include <QMessageBox>
#include <QPushButton>

namespace hitos::window {
namespace {

QString translated(const char* text) {
    return QCoreApplication::translate("Prompts", text);
}

}  // namespace

QString QtPrompts::open_file(QWidget* parent, const FileQuestion& question) {
    return QFileDialog::getOpenFileName(parent, question.title, question.start, question.filters);
}

QString QtPrompts::save_file(QWidget* parent, const FileQuestion& question) {
    QString filter;
    // Whether a file may be replaced is asked by the caller, the same way everywhere.
    QString path =
        QFileDialog::getSaveFileName(parent, question.title, question.start, question.filters,
                                     &filter, QFileDialog::DontConfirmOverwrite);
    if (!path.isEmpty() && QFileInfo(path).suffix().isEmpty() && !question.suffix.isEmpty()) {
        path += '.' + question.suffix;
    }
    return path;
}

QString QtPrompts::choose_folder(QWidget* parent, const QString& title, const QString& start) {
    return QFileDialog::getExistingDirectory(parent, title, start);
}

bool QtPrompts::confirm(QWidget* parent, const Question& question) {
    QMessageBox box(QMessageBox::Question, question.title, question.text, QMessageBox::Cancel,
                    parent);
    box.setInformativeText(question.details);
    QPushButton* accept = box.addButton(question.accept, QMessageBox::AcceptRole);
    box.setDefaultButton(accept);
    box.exec();
    return box.clickedButton() == accept;
}

void QtPrompts::warn(QWidget* parent, const QString& title, const QString& text) {
    QMessageBox::warning(parent, title, text);
}

bool may_overwrite(Prompts& prompts, QWidget* parent, const QString& path) {
    return prompts.confirm(
        parent,
        {translated(QT_TRANSLATE_NOOP("Prompts", "The file exists")),
         translated(QT_TRANSLATE_NOOP("Prompts", "Replace %1?")).arg(QFileInfo(path).fileName()),
         translated(QT_TRANSLATE_NOOP("Prompts", "What it holds now will be lost.")),
         translated(QT_TRANSLATE_NOOP("Prompts", "Replace"))});
}

void tell_not_written(Prompts& prompts, QWidget* parent, const QString& reason) {
    prompts.warn(parent, translated(QT_TRANSLATE_NOOP("Prompts", "The file was not written")),
                 reason);
}

}  // namespace hitos::window
