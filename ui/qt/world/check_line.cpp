#include "check_line.hpp"

#include <QStringList>

#include "app/theme.hpp"
#include "app/words_of.hpp"
#include "hitos/simulation/world_check.hpp"
#include "workers/background.hpp"

namespace hitos::window {

CheckLine::CheckLine(QWidget* parent) : QLabel(parent) {
    setObjectName("world_check");
    setWordWrap(true);
    setTextInteractionFlags(Qt::TextSelectableByMouse);
    constexpr int kPauseMs = 150;
    pause_.setSingleShot(true);
    pause_.setInterval(kPauseMs);
    pool_.setMaxThreadCount(1);
    connect(&pause_, &QTimer::timeout, this, &CheckLine::begin);
}

CheckLine::~CheckLine() {
    pool_.waitForDone();
}

void CheckLine::check(const World& world) {
    world_ = world;
    ++asked_;
    setEnabled(false);  // what it says is about what was before
    pause_.start();
}

void CheckLine::begin() {
    if (busy_) return;  // it begins anew when the one under way is done
    busy_ = true;
    pool_.start([this, world = world_, number = asked_] {
        begin_background_work();
        QStringList words;
        bool good = false;
        try {
            const WorldCheck check = check_world(world);
            good = check.good();
            for (const Message& sentence : sentences_of(check, world)) {
                words << words_of(sentence);
            }
        } catch (const std::exception& error) {
            words << words_of(error);
        }
        QMetaObject::invokeMethod(this, [this, number, words, good] {
            show_result(number, words.join(QStringLiteral(" · ")), good);
        });
    });
}

void CheckLine::show_result(std::uint64_t number, const QString& words, bool good) {
    busy_ = false;
    if (number != asked_) {
        if (!pause_.isActive()) begin();
        return;
    }
    shown_ = number;
    setEnabled(true);
    setText(world_.walls.empty() ? tr("Nothing is drawn yet.") : words);
    set_look(*this, "role", good || world_.walls.empty() ? "muted" : "warning");
}

}  // namespace hitos::window
