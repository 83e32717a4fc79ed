// SPDX-License-Identifier: GPL-3.0-or-later
#include "spoken.hpp"

#include <QDir>
#include <QRegularExpression>
#include <QTest>
#include <QTranslator>
#include <QWidget>
#include <QXmlStreamReader>
#include <algorithm>

#include "app/application.hpp"
#include "app/language.hpp"
#include "gui_fixture.hpp"
#include "session_eyes.hpp"

namespace hitos::window {
namespace {

/// What is said whatever the values are.
QStringList pieces_of(const QString& sentence) {
    static const QRegularExpression place_of_value("%[0-9]");
    return as_read(sentence).split(place_of_value);
}

/// Of the sentence with its values, each of which is caught.
QRegularExpression pattern_of(QStringList pieces) {
    for (QString& piece : pieces) piece = QRegularExpression::escape(piece);
    return QRegularExpression('^' + pieces.join("(.+)") + '$');
}

}  // namespace

void add_languages() {
    QTest::addColumn<QString>("language");
    for (const char* language : {"en", "es"}) QTest::addRow("%s", language) << language;
}

Spoken::Spoken(const QString& language) {
    speak(*qApp, language);
    if (language == "en") return;
    QXmlStreamReader file(
        Fixture::read(Fixture::source_file("ui/qt/translations/hitos_" + language + ".ts")));
    QString english;
    while (!file.atEnd()) {
        if (file.readNext() != QXmlStreamReader::StartElement) continue;
        if (file.name() == u"source") english = file.readElementText();
        if (file.name() == u"translation") sentences_.append({english, file.readElementText()});
    }
}

Spoken::~Spoken() {
    qDeleteAll(qApp->findChildren<QTranslator*>());
    speak(*qApp, "en");
}

/// Asked again and again while somebody waits for the words, and then as fast as English.
QStringList Spoken::said(const QString& words) const {
    const auto known = found_.constFind(words);
    return known != found_.cend() ? *known : *found_.insert(words, looked_up(words));
}

QStringList Spoken::looked_up(const QString& words) const {
    QStringList all;
    for (const auto& [english, other] : sentences_)
        if (as_read(english) == words) all << as_read(other);
    if (!all.isEmpty() || sentences_.isEmpty()) return all << words;
    all << in_sentences(words);
    // Put together of what is said elsewhere: "Closed: somebody wants it." is of two.
    for (const char* joint : {": ", " ("}) {
        const qsizetype at = words.indexOf(joint);
        if (at > 0) all << said(words.left(at)).front() + joint + said(words.mid(at + 2)).front();
    }
    if (words.endsWith('.') || words.endsWith(')'))
        all << said(words.chopped(1)).front() + words.back();
    // What Qt writes on its own buttons.
    return all << as_read(QCoreApplication::translate("QPlatformTheme", qPrintable(words)))
               << words;
}

/// By the sentence that says most of it: some are hardly more than their values.
QStringList Spoken::in_sentences(const QString& words) const {
    QStringList all;
    qsizetype most = 3;
    for (const auto& [english, other] : sentences_) {
        const QStringList pieces = pieces_of(english);
        const QRegularExpressionMatch match = pattern_of(pieces).match(words);
        const bool begun = pieces.front().startsWith(words) || words.startsWith(pieces.front());
        const qsizetype sure = match.hasMatch() ? pieces.join("").size()
                               : begun          ? std::min(words.size(), pieces.front().size())
                                                : 0;
        if (sure < most) continue;
        if (sure > most) all.clear();
        most = sure;
        QString filled = as_read(other);
        for (int value = 1; value <= match.lastCapturedIndex(); ++value)
            filled.replace('%' + QString::number(value), said(match.captured(value)).front());
        const QStringList told = pieces_of(filled);
        all << std::ranges::max_element(told, {}, &QString::size)->trimmed();
    }
    return all;
}

QString Spoken::key(const QString& name) const {
    if (!name.startsWith("Alt+")) return name;
    const QString mark = '&' + name.last(1);
    for (const auto& [english, other] : sentences_) {
        const qsizetype letter = other.indexOf('&') + 1;
        if (letter == 0 || !english.contains(mark, Qt::CaseInsensitive)) continue;
        const Target target = target_of({as_read(other)});
        if (target.widget && target.widget->window() == window_above())
            return "Alt+" + other.mid(letter, 1);
    }
    return name;
}

bool keep_picture(QWidget& of, const QString& name) {
    const QImage picture = of.grab().toImage();
    const QString language = spoken_language();
    QDir folder(qEnvironmentVariable("HITOS_PICTURES"));
    if (qEnvironmentVariableIsEmpty("HITOS_PICTURES")) return !picture.isNull();
    if (language != "en" && !(folder.mkpath(language) && folder.cd(language))) return false;
    constexpr int kSmallest = 0;  // Qt's name for it is the worst quality; nothing is lost
    return picture.save(folder.filePath(name), "PNG", kSmallest);
}

}  // namespace hitos::window
