// SPDX-License-Identifier: GPL-3.0-or-later
#include "application.hpp"

#include <QApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

#include "hitos/services/results/results.hpp"
#include "look/written_number.hpp"

static void use_resources() {
    Q_INIT_RESOURCE(translations);
}

namespace hitos::window {

void prepare_application() {
    use_resources();
    qApp->installEventFilter(new NumberBoxes(qApp));
    QApplication::setApplicationName("hitos");
    QApplication::setApplicationDisplayName("Hitos");
    QApplication::setApplicationVersion(QString::fromStdString(version()));
    QApplication::setDesktopFileName("hitos");
}

void speak(QApplication& application, const QString& language) {
    const QLocale locale = language.isEmpty() ? QLocale::system() : QLocale(language);
    // Files and command lines write numbers with a point; so does the window. What is written in it
    // may have the country's comma.
    QLocale::setDefault(QLocale::c());
    set_decimal_comma(locale.decimalPoint() == ",");
    if (locale.language() != QLocale::Spanish) return;
    auto* qt_words = new QTranslator(&application);
    if (qt_words->load("qtbase_es", QLibraryInfo::path(QLibraryInfo::TranslationsPath))) {
        QApplication::installTranslator(qt_words);
    }
    auto* words = new QTranslator(&application);
    if (words->load(":/i18n/hitos_es.qm")) QApplication::installTranslator(words);
}

}  // namespace hitos::window
