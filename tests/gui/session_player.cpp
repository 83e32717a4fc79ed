// SPDX-License-Identifier: GPL-3.0-or-later
#include "session_player.hpp"

#include <QDir>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QKeySequence>
#include <QLineEdit>
#include <QRegularExpression>
#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "actions/command_line.hpp"
#include "app/application.hpp"
#include "app/opening.hpp"
#include "keyboard.hpp"
#include "look/screen_fit.hpp"
#include "runs/runs.hpp"
#include "session_eyes.hpp"
#include "spoken.hpp"
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

QString short_lines(QStringList lines) {
    constexpr int kWidth = 100;
    for (QString& line : lines) line = line.left(kWidth);
    return lines.join('\n');
}

/// Any of these.
bool is_written(const QStringList& words) {
    return std::ranges::any_of(all_in_sight(), [&](const QString& text) {
        return std::ranges::any_of(words, [&](const QString& one) { return text.contains(one); });
    });
}

/// Where nobody manages windows, the one above asks for the keyboard itself.
bool has_keyboard() {
    if (QApplication::activePopupWidget() != nullptr) return true;
    QWidget* above = window_above();
    if (above == nullptr) return false;
    if (!above->isActiveWindow()) above->activateWindow();
    return above->isActiveWindow();
}

QWidget* what_listens() {
    if (QWidget* menu = QApplication::activePopupWidget()) return menu;
    if (QWidget* focused = QApplication::focusWidget()) return focused;
    return window_above();
}

QLineEdit* file_name_field() {
    const auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    return dialog != nullptr ? dialog->findChild<QLineEdit*>("fileNameEdit") : nullptr;
}

/// "world_view at 8 0": the name, and the place in it.
struct Aim {
    QString name;
    bool placed = false;
    QPointF place;

    explicit Aim(const QString& words) : name(words) {
        static const QRegularExpression at("^(.*) at (-?[0-9.]+) (-?[0-9.]+)$");
        const QRegularExpressionMatch match = at.match(words);
        if (!match.hasMatch()) return;
        name = match.captured(1);
        placed = true;
        place = {match.captured(2).toDouble(), match.captured(3).toDouble()};
    }
};

/// Plays from the event loop, so that a dialog that waits for its answer gets it.
class Player final : public QObject {
  public:
    Player(KeyboardFixture& fixture, const Spoken& spoken, std::vector<Step> steps, int patience_ms)
        : f_(fixture), spoken_(spoken), steps_(std::move(steps)), patience_ms_(patience_ms) {}

    /// Empty, or what did not come true, with its line.
    QString play() {
        since_.start();
        next();
        loop_.exec();
        return failure_;
    }
    const Effort& effort() const { return effort_; }

  private:
    struct Verb {
        const char* wanting;  ///< what is told where it is not possible
        bool (Player::*possible)(const QString& rest);
        void (Player::*act)(const QString& rest);
    };

    static const std::map<QString, Verb>& verbs() {
        static const std::map<QString, Verb> all{
            {"size", {"there is no window", &Player::has_window, &Player::give_size}},
            {"press", {"nothing has the keyboard", &Player::listens, &Player::press_key}},
            {"type", {"nothing has the keyboard", &Player::listens, &Player::type_words}},
            {"file", {"no file is asked for", &Player::asks_for_file, &Player::name_file}},
            {"click", {"it is not to be clicked", &Player::is_target, &Player::click}},
            {"double", {"it is not to be clicked", &Player::is_target, &Player::click_twice}},
            {"see", {"it is not in sight", &Player::is_in_sight, &Player::nothing}},
            {"gone", {"it is still in sight", &Player::is_gone, &Player::nothing}},
            {"written", {"it is not written", &Player::is_file, &Player::nothing}},
            {"rest", {"it does not come to rest", &Player::rests_for_a_while, &Player::nothing}},
            {"drive", {"there is no robot to drive", &Player::has_robot, &Player::drive}},
            {"picture", {"there is no window", &Player::has_window, &Player::take_picture}}};
        return all;
    }

    void next() { QTimer::singleShot(5, this, &Player::advance); }

    void advance() {
        if (!failure_.isEmpty()) return;
        if (QGuiApplication::overrideCursor() != nullptr) {  // input waits
            next();
            return;
        }
        if (at_ == steps_.size()) {
            if (QWidget* left = QApplication::activeModalWidget())
                failure_ = "a dialog waits at the end: " + left->windowTitle();
            finish();
            return;
        }
        const Step& step = steps_[at_];
        const auto verb = verbs().find(step.verb);
        if (verb == verbs().end()) {
            fail("nothing is known under this word", at_);
            return;
        }
        if (!(this->*verb->second.possible)(step.rest)) {
            if (since_.elapsed() <= patience_ms_) {
                next();
            } else {
                fail(verb->second.wanting + QString("; in sight:\n") + short_lines(all_in_sight()),
                     at_);
            }
            return;
        }
        next();  // a dialog that this step opens ends within it
        ++at_;
        since_.restart();
        resting_.invalidate();
        (this->*verb->second.act)(step.rest);
        since_.restart();  // a list that it opened has been there since now
    }

    /// Of the step that is being taken or waited for.
    void fail(const QString& why, std::size_t place) {
        const Step& step = steps_[place];
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

    // What has to be so before a step is taken.

    bool has_window(const QString& /*rest*/) { return window_above() != nullptr; }
    bool listens(const QString& /*rest*/) { return has_keyboard(); }
    bool asks_for_file(const QString& /*rest*/) {
        return has_keyboard() && file_name_field() != nullptr;
    }
    bool is_in_sight(const QString& words) { return is_written(spoken_.said(words)); }
    bool is_gone(const QString& words) { return !is_written(spoken_.said(words)); }
    bool is_file(const QString& path) { return QFileInfo(path).size() > 0; }

    Target target_under(const QString& words) const { return target_of(spoken_.said(words)); }

    bool is_target(const QString& rest) {
        const Target target = target_under(Aim(rest).name);
        constexpr int kAfterOpening = 100;
        const int wait = target.slow ? QApplication::doubleClickInterval() + kAfterOpening : 0;
        return target.widget != nullptr && since_.elapsed() >= wait;
    }

    bool has_robot(const QString& /*rest*/) {
        const auto* workshop = f_.window->findChild<WorldWindow*>();
        return workshop != nullptr && workshop->isVisible();
    }

    bool rests_for_a_while(const QString& /*rest*/) {
        constexpr int kSettleMs = 300;
        if (!rests()) {
            resting_.invalidate();
        } else if (!resting_.isValid()) {
            resting_.start();
        }
        return resting_.isValid() && resting_.elapsed() > kSettleMs;
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

    // The steps.

    void nothing(const QString& /*rest*/) {}

    void give_size(const QString& size) { apply_size(*window_above(), size.toStdString()); }

    void press_key(const QString& name) {
        const QKeySequence keys(spoken_.key(name));
        if (keys.count() != 1 || keys[0].key() == Qt::Key_unknown) {
            fail("there is no such key", at_ - 1);
            return;
        }
        ++effort_.keys;
        QTest::keyClick(what_listens(), keys[0].key(), keys[0].keyboardModifiers());
    }

    void type_words(const QString& words) {
        effort_.keys += static_cast<int>(words.size());
        QTest::keyClicks(what_listens(), words);
    }

    /// What its completer shows is not chosen.
    void name_file(const QString& path) {
        const QPointer<QWidget> dialog(QApplication::activeModalWidget());
        QLineEdit* name = file_name_field();
        name->clear();  // it is selected where a user comes to it
        effort_.keys += static_cast<int>(path.size()) + 1;
        QTest::keyClicks(name, QDir::current().absoluteFilePath(path));
        for (int tries = 0; dialog && dialog->isVisible() && tries < 3; ++tries) {
            QWidget* above = QApplication::activePopupWidget();
            QTest::keyClick(above != nullptr ? above : name, Qt::Key_Return);
        }
    }

    void click(const QString& rest) { click_at(rest, false); }
    void click_twice(const QString& rest) { click_at(rest, true); }

    void click_at(const QString& rest, bool twice) {
        const Aim aim(rest);
        const Target target = target_under(aim.name);
        QWidget* widget = target.widget;
        QPoint place = target.at;
        if (const auto* view = qobject_cast<CanvasView*>(widget); aim.placed && view != nullptr) {
            place = view->camera().to_screen(view->size()).map(aim.place).toPoint();
        } else if (aim.placed) {
            place = QPoint(static_cast<int>(aim.place.x() * widget->width()),
                           static_cast<int>(aim.place.y() * widget->height()));
        }
        if (qobject_cast<QAbstractButton*>(widget) == nullptr) {
            if (QWidget* inner = widget->childAt(place)) {
                place = inner->mapFrom(widget, place);
                widget = inner;
            }
        }
        if (QApplication::activePopupWidget() == nullptr) widget->window()->activateWindow();
        ++effort_.clicks;
        const QPointer<QWidget> still(widget);
        QTest::mouseClick(widget, Qt::LeftButton, {}, place);
        if (twice && still) QTest::mouseDClick(widget, Qt::LeftButton, {}, place);
    }

    void drive(const QString& periods) {
        LiveDrive& drive = f_.window->findChild<WorldWindow*>()->drive();
        drive.rest();  // the session is the clock
        for (int k = 0; k < periods.toInt(); ++k) drive.drive_period();
    }

    void take_picture(const QString& name) {
        if (!keep_picture(*window_above(), name)) fail("the picture was not made", at_ - 1);
    }

    KeyboardFixture& f_;
    const Spoken& spoken_;
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
    Desk() : before_(QDir::currentPath()), pictures_(qgetenv("HITOS_PICTURES")) {
        if (!pictures_.isEmpty())
            qputenv("HITOS_PICTURES", QFileInfo(pictures_).absoluteFilePath().toLocal8Bit());
        for (const QString& name : {QString("data"), QString("config")})
            QFile::link(Fixture::source_file(name), folder_.filePath(name));
        QDir().mkpath(folder_.filePath("out"));
        QDir::setCurrent(folder_.path());
    }
    ~Desk() {
        QDir::setCurrent(before_);
        if (!pictures_.isEmpty()) qputenv("HITOS_PICTURES", pictures_);
    }
    Desk(const Desk&) = delete;
    Desk& operator=(const Desk&) = delete;

  private:
    QTemporaryDir folder_;
    QString before_;
    QByteArray pictures_;
};

/// The theme of a session, and that of the tests again.
class Look {
  public:
    explicit Look(const std::string& theme) {
        apply_theme(*qApp, theme == "dark" ? Theme::dark : Theme::light);
    }
    ~Look() { apply_theme(*qApp, Theme::light); }
    Look(const Look&) = delete;
    Look& operator=(const Look&) = delete;
};

/// False where it is no command line of a window that somebody looks at.
bool parse_words(const QString& words, CommandLine& line) {
    std::vector<std::string> arguments{"hitos"};
    for (const QString& word : words.split(' ', Qt::SkipEmptyParts))
        arguments.push_back(word.toStdString());
    std::vector<char*> pointers;
    pointers.reserve(arguments.size());
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    if (parse(static_cast<int>(pointers.size()), pointers.data(), line)) return false;
    return line.screenshot.empty();
}

QString play_in(const CommandLine& line, const Spoken& spoken, std::vector<Step> steps,
                int patience_ms, Effort& effort) {
    KeyboardFixture f(0);
    apply_size(*f.window, line.size);
    open_named(*f.window, line, Audience::somebody);
    begin(*f.window, f.session, line);
    QElapsedTimer clock;
    clock.start();
    Player player(f, spoken, std::move(steps), patience_ms);
    QString failure = player.play();
    effort = player.effort();
    effort.seconds = static_cast<double>(clock.elapsed()) / 1000.0;
    return failure;
}

/// HITOS_SESSION_PATIENCE, in seconds, is for whoever writes a session.
int patience_ms() {
    const int seconds = qEnvironmentVariableIntValue("HITOS_SESSION_PATIENCE");
    return seconds > 0 ? 1000 * seconds : kPatienceMs;
}

}  // namespace

QString failure_of_session(const QString& file, int patience_ms, Effort* effort,
                           const QString& language) {
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
    const Spoken spoken(line.language.empty() ? language : QString::fromStdString(line.language));
    const Look look(line.theme);
    Effort spent;
    QString failure = play_in(line, spoken, std::move(steps), patience_ms, spent);
    const QString found = QString("%1 clicks, %2 keys").arg(spent.clicks).arg(spent.keys);
    if (failure.isEmpty() && found != wanted) failure = "effort: found " + found;
    if (effort != nullptr) *effort = spent;
    return failure;
}

Effort play_session(const QString& file, const QString& language) {
    Effort effort;
    const QString failure = failure_of_session(file, patience_ms(), &effort, language);
    if (!failure.isEmpty()) QTest::qFail(qPrintable(failure), qPrintable(file), 0);
    return effort;
}

}  // namespace hitos::window
