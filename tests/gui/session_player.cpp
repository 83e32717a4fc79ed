#include "session_player.hpp"

#include <QDir>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QFile>
#include <QFileDialog>
#include <QKeySequence>
#include <QRegularExpression>
#include <QTranslator>
#include <algorithm>
#include <string>
#include <vector>

#include "actions/command_line.hpp"
#include "app/application.hpp"
#include "keyboard.hpp"
#include "look/screen_fit.hpp"
#include "runs/runs.hpp"
#include "session_eyes.hpp"
#include "workers/log_counter.hpp"
#include "world/check_line.hpp"
#include "world/live_drive.hpp"
#include "world/world_window.hpp"

namespace hitos::window {
namespace {

struct Step {
    int line = 0;
    QString verb;
    QString rest;
};

std::vector<Step> steps_of(const QString& file) {
    std::vector<Step> steps;
    const QStringList lines = QString::fromUtf8(Fixture::read(file)).split('\n');
    for (int i = 0; i < lines.size(); ++i) {
        const QString line = lines[i].trimmed();
        if (line.isEmpty() || line.startsWith('#')) continue;
        const QString verb = line.section(' ', 0, 0);
        const QString rest = line.section(' ', 1).trimmed();
        // What a key does, such as to close a dialog, is done before the next.
        for (const QString& part : verb == "press" ? rest.split(' ') : QStringList{rest})
            steps.push_back({i + 1, verb, part});
    }
    return steps;
}

/// The four numbers of "from 1 2 to 3 4", the two of "at 1 2".
std::vector<double> numbers_in(const QString& text) {
    std::vector<double> numbers;
    for (const QString& word : text.split(' ')) {
        bool is = false;
        if (const double number = word.toDouble(&is); is) numbers.push_back(number);
    }
    return numbers;
}

QString short_lines(QStringList lines) {
    constexpr int kWidth = 100;
    for (QString& line : lines) line = line.left(kWidth);
    return lines.join('\n');
}

/// Plays from the event loop, so that a dialog that waits for its answer gets it.
class Player final : public QObject {
  public:
    Player(KeyboardFixture& fixture, std::vector<Step> steps, int patience_ms)
        : f_(fixture), steps_(std::move(steps)), patience_ms_(patience_ms) {}

    /// Empty, or what did not come true, with its line.
    QString play() {
        since_.start();
        next();
        loop_.exec();
        return failure_;
    }
    const Effort& effort() const { return effort_; }

  private:
    void next() { QTimer::singleShot(5, this, &Player::advance); }

    void advance() {
        if (at_ == steps_.size()) {
            if (QWidget* left = QApplication::activeModalWidget())
                failure_ = "a dialog waits at the end: " + left->windowTitle();
            finish();
            return;
        }
        const Step step = steps_[at_];
        QString wanting;
        const bool ready = is_ready(step, wanting);
        if (!ready && wanting.isEmpty()) {
            fail(step, "nothing is known under the word " + step.verb);
        } else if (!ready && since_.elapsed() > patience_ms_) {
            fail(step, wanting + "; in sight:\n" + short_lines(all_in_sight()));
        } else {
            // A dialog opened by this step ends within it.
            if (ready) ++at_;
            next();
            if (!ready) return;
            since_.restart();
            resting_.invalidate();
            perform(step);
        }
    }

    void fail(const Step& step, const QString& why) {
        failure_ = QString("line %1, %2 %3: %4").arg(step.line).arg(step.verb, step.rest, why);
        finish();
    }

    void finish() {
        while (QWidget* popup = QApplication::activePopupWidget()) popup->close();
        if (QWidget* dialog = QApplication::activeModalWidget()) {
            dialog->close();
            QTimer::singleShot(10, this, &Player::finish);  // there may be another below
            return;
        }
        loop_.quit();
    }

    bool is_ready(const Step& step, QString& wanting) {
        const QString& verb = step.verb;
        if (verb == "click" || verb == "double" || verb == "menu" || verb == "point" ||
            verb == "drag") {
            wanting = "it is not to be clicked";
            const Target target = target_of(name_in(step.rest));
            constexpr int kAfterOpening = 100;
            const int wait = target.slow ? QApplication::doubleClickInterval() + kAfterOpening : 0;
            return target.widget != nullptr && since_.elapsed() >= wait;
        }
        if (verb == "see" || verb == "gone") {
            wanting = verb == "see" ? "it is not in sight" : "it is still in sight";
            const QStringList seen = all_in_sight();
            const bool there = std::ranges::any_of(
                seen, [&step](const QString& text) { return text.contains(step.rest); });
            return there == (verb == "see");
        }
        if (verb == "rest") {
            wanting = "it does not come to rest";
            constexpr int kSettleMs = 300;
            if (!rests()) {
                resting_.invalidate();
            } else if (!resting_.isValid()) {
                resting_.start();
            }
            return resting_.isValid() && resting_.elapsed() > kSettleMs;
        }
        if (verb == "press" || verb == "type" || verb == "hold" || verb == "file") {
            wanting = "nothing has the keyboard";
            if (verb == "file" &&
                qobject_cast<QFileDialog*>(QApplication::activeModalWidget()) == nullptr)
                return false;
            return has_keyboard();
        }
        wanting = known_otherwise(verb) ? "it is not possible" : QString();
        return known_otherwise(verb);
    }

    static bool known_otherwise(const QString& verb) {
        return QStringList{"size", "release", "drive", "picture"}.contains(verb);
    }

    /// Where nobody manages windows, the one above asks for the keyboard itself.
    static bool has_keyboard() {
        if (QApplication::activePopupWidget() != nullptr) return true;
        QWidget* above = window_above();
        if (above == nullptr) return false;
        if (!above->isActiveWindow()) above->activateWindow();
        return above->isActiveWindow();
    }

    bool rests() const {
        auto* workshop = f_.window->findChild<WorldWindow*>();
        const LiveDrive* drive = workshop != nullptr ? &workshop->drive() : nullptr;
        if (drive != nullptr && drive->active())
            return f_.steps() == drive->tour()->scans() && f_.shows_everything();
        if (f_.state() == Progress::State::running) return false;
        if (f_.steps() > 0 && !f_.shows_everything()) return false;
        if (QThreadPool::globalInstance()->activeThreadCount() > 0) return false;
        if (const auto* counter = f_.window->findChild<LogCounter*>(); counter && counter->busy())
            return false;
        for (QWidget* window : QApplication::topLevelWidgets()) {
            auto* map = qobject_cast<MapWindow*>(window);
            if (map != nullptr && map->builder().state().running) return false;
        }
        const CompareWindow* comparison = f_.window->runs().comparison();
        if (comparison != nullptr && comparison->building()) return false;
        return workshop == nullptr || !workshop->isVisible() || workshop->check_line().up_to_date();
    }

    static QString name_in(const QString& rest) {
        static const QRegularExpression place(" (at|from) -?[0-9].*$");
        return QString(rest).remove(place);
    }

    void perform(const Step& step) {
        const QString& verb = step.verb;
        if (verb == "size") {
            apply_size(*window_above(), step.rest.toStdString());
        } else if (verb == "press") {
            press_key(step);
        } else if (verb == "hold" || verb == "release") {
            const auto key = QKeySequence(step.rest)[0].key();
            verb == "hold" ? QTest::keyPress(listener_now(), key)
                           : QTest::keyRelease(listener_now(), key);
            effort_.keys += verb == "hold" ? 1 : 0;
        } else if (verb == "type") {
            type_words(step.rest);
        } else if (verb == "file") {
            name_file(step.rest);
        } else if (verb == "drive") {
            LiveDrive& drive = f_.window->findChild<WorldWindow*>()->drive();
            drive.rest();
            for (int k = 0; k < step.rest.toInt(); ++k) drive.drive_period();
        } else if (verb == "picture") {
            take_picture(step);
        } else if (verb != "see" && verb != "gone" && verb != "rest") {
            use_mouse(verb, target_of(name_in(step.rest)), numbers_in(step.rest));
        }
    }

    static QWidget* listener_now() {
        if (QWidget* menu = QApplication::activePopupWidget()) return menu;
        if (QWidget* focused = QApplication::focusWidget()) return focused;
        return window_above();
    }

    void press_key(const Step& step) {
        const QKeySequence keys(step.rest);
        if (keys.count() != 1 || keys[0].key() == Qt::Key_unknown) {
            fail(step, "there is no such key");
            return;
        }
        ++effort_.keys;
        QTest::keyClick(listener_now(), keys[0].key(), keys[0].keyboardModifiers());
    }

    void type_words(const QString& words) {
        effort_.keys += int(words.size());
        QTest::keyClicks(listener_now(), words);
    }

    /// What its completer shows is not chosen.
    void name_file(const QString& path) {
        const QPointer<QWidget> dialog(QApplication::activeModalWidget());
        auto* name = dialog->findChild<QLineEdit*>("fileNameEdit");
        name->clear();  // it is selected where a user comes to it
        effort_.keys += int(path.size()) + 1;
        QTest::keyClicks(name, QDir::current().absoluteFilePath(path));
        for (int tries = 0; dialog && dialog->isVisible() && tries < 3; ++tries) {
            QWidget* above = QApplication::activePopupWidget();
            QTest::keyClick(above != nullptr ? above : name, Qt::Key_Return);
        }
    }

    void use_mouse(const QString& verb, const Target& target, const std::vector<double>& at) {
        QWidget* widget = target.widget;
        QPoint place = target.at;
        auto* view = qobject_cast<CanvasView*>(widget);
        const auto pixel = [view, widget](double x, double y) {
            if (view == nullptr)
                return QPointF(x * widget->width(), y * widget->height()).toPoint();
            return view->camera().to_screen(view->size()).map(QPointF(x, y)).toPoint();
        };
        if (at.size() >= 2) place = pixel(at[0], at[1]);
        if (qobject_cast<QAbstractButton*>(widget) == nullptr) {
            if (QWidget* inner = widget->childAt(place)) {
                place = inner->mapFrom(widget, place);
                widget = inner;
            }
        }
        if (QApplication::activePopupWidget() == nullptr) widget->window()->activateWindow();
        effort_.clicks += verb == "point" ? 0 : 1;
        if (verb == "point") {
            move_mouse(*widget, place, Qt::NoButton);
        } else if (verb == "drag") {
            QTest::mousePress(widget, Qt::LeftButton, {}, place);
            const QPoint end = pixel(at[2], at[3]);
            for (const double share : {0.3, 0.7, 1.0})
                move_mouse(*widget, place + share * (end - place), Qt::LeftButton);
            QTest::mouseRelease(widget, Qt::LeftButton, {}, end);
        } else if (verb == "menu") {
            QContextMenuEvent event(QContextMenuEvent::Mouse, place, widget->mapToGlobal(place));
            QApplication::sendEvent(widget, &event);
        } else {
            const QPointer<QWidget> still(widget);
            QTest::mouseClick(widget, Qt::LeftButton, {}, place);
            if (verb == "double" && still) QTest::mouseDClick(widget, Qt::LeftButton, {}, place);
        }
    }

    static void move_mouse(QWidget& widget, QPoint place, Qt::MouseButton held) {
        // Without a screen a move of the mouse itself is heard of by nobody.
        QMouseEvent event(QEvent::MouseMove, place, widget.mapToGlobal(place), Qt::NoButton, held,
                          Qt::NoModifier);
        QApplication::sendEvent(&widget, &event);
    }

    void take_picture(const Step& step) {
        const QImage picture = window_above()->grab().toImage();
        const QString folder = qEnvironmentVariable("HITOS_PICTURES");
        if (picture.isNull() || (!folder.isEmpty() && !picture.save(folder + '/' + step.rest)))
            fail(step, "the picture was not made");
    }

    KeyboardFixture& f_;
    std::vector<Step> steps_;
    int patience_ms_;
    std::size_t at_ = 0;
    QEventLoop loop_;
    QElapsedTimer since_;  ///< the step before
    QElapsedTimer resting_;
    QString failure_;
    Effort effort_;
};

/// A folder that looks like the sources, in which the session may write.
class Desk {
  public:
    Desk() : before_(QDir::currentPath()) {
        for (const QString& name : {QString("data"), QString("config")})
            QFile::link(Fixture::source_file(name), folder_.filePath(name));
        QDir().mkpath(folder_.filePath("out"));
        QDir::setCurrent(folder_.path());
    }
    ~Desk() { QDir::setCurrent(before_); }

  private:
    QTemporaryDir folder_;
    QString before_;
};

bool parse_words(const QString& words, CommandLine& line) {
    std::vector<std::string> arguments{"hitos"};
    for (const QString& word : words.split(' ', Qt::SkipEmptyParts))
        arguments.push_back(word.toStdString());
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    return !parse(int(pointers.size()), pointers.data(), line).has_value();
}

QString play_in(const CommandLine& line, std::vector<Step> steps, int patience_ms, Effort& effort) {
    KeyboardFixture f(0);
    apply_size(*f.window, line.size);
    f.window->configuration_actions().start_or_warn(line);
    if (line.open.empty() && line.config.empty()) f.window->offer_start();
    QElapsedTimer clock;
    clock.start();
    Player player(f, std::move(steps), patience_ms);
    QString failure = player.play();
    effort = player.effort();
    effort.seconds = double(clock.elapsed()) / 1000.0;
    return failure;
}

}  // namespace

QString failure_of_session(const QString& file, int patience_ms, Effort* effort) {
    std::vector<Step> steps = steps_of(file);
    CommandLine line;
    if (steps.size() < 2 || steps.front().verb != "hitos" || steps.back().verb != "effort" ||
        !parse_words(steps.front().rest, line)) {
        return "expected hitos ARGUMENTS as the first line, effort C clicks, K keys as the last";
    }
    const QString wanted = steps.back().rest;
    steps.erase(steps.begin());
    steps.pop_back();
    const Desk desk;
    auto& application = *qobject_cast<QApplication*>(QCoreApplication::instance());
    speak(application, line.language.empty() ? "en" : QString::fromStdString(line.language));
    apply_theme(application, line.theme == "dark" ? Theme::dark : Theme::light);
    Effort spent;
    QString failure = play_in(line, std::move(steps), patience_ms, spent);
    for (QTranslator* words : application.findChildren<QTranslator*>()) delete words;
    speak(application, "en");
    apply_theme(application, Theme::light);
    const QString found = QString("%1 clicks, %2 keys").arg(spent.clicks).arg(spent.keys);
    if (failure.isEmpty() && found != wanted) failure = "effort: found " + found;
    if (effort != nullptr) *effort = spent;
    return failure;
}

/// HITOS_SESSION_PATIENCE, in seconds, is for whoever writes a session.
static int patience_ms() {
    const int seconds = qEnvironmentVariableIntValue("HITOS_SESSION_PATIENCE");
    return seconds > 0 ? 1000 * seconds : kPatienceMs;
}

Effort play_session(const QString& file) {
    Effort effort;
    const QString failure = failure_of_session(file, patience_ms(), &effort);
    if (!failure.isEmpty()) QTest::qFail(qPrintable(failure), qPrintable(file), 0);
    return effort;
}

}  // namespace hitos::window
