#include "application.hpp"

#include <QApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

#include "hitos/services/results/results.hpp"

static void use_resources() {
    Q_INIT_RESOURCE(translations);
}

namespace hitos::window {

void prepare_application() {
    use_resources();
    QApplication::setApplicationName("hitos");
    QApplication::setApplicationDisplayName("Hitos");
    QApplication::setApplicationVersion(QString::fromStdString(version()));
    QApplication::setDesktopFileName("hitos");
}

void speak(QApplication& application, const QString& language) {
    const QLocale locale = language.isEmpty() ? QLocale::system() : QLocale(language);
    // Files and command lines write numbers with a point; so does the window.
    QLocale::setDefault(QLocale::c());
    if (locale.language() != QLocale::Spanish) return;
    auto* qt_words = new QTranslator(&application);
    if (qt_words->load("qtbase_es", QLibraryInfo::path(QLibraryInfo::TranslationsPath))) {
        QApplication::installTranslator(qt_words);
    }
    auto* words = new QTranslator(&application);
    if (words->load(":/i18n/hitos_es.qm")) QApplication::installTranslator(words);
}

}  // namespace hitos::window
