// SPDX-License-Identifier: GPL-3.0-or-later
// Whether what is drawn can be driven, in words below it.
#pragma once

#include <QLabel>
#include <QThreadPool>
#include <QTimer>
#include <cstdint>

#include "hitos/simulation/worlds/world.hpp"

namespace hitos::window {

/// Checks beside the window, since a tour may be long; the newest world only.
class CheckLine final : public QLabel {
    Q_OBJECT

  public:
    explicit CheckLine(QWidget* parent);
    ~CheckLine() override;

    void check(const World& world);
    /// What is shown is about the newest world.
    bool up_to_date() const { return shown_ == asked_; }

  private:
    void begin();
    void show_result(std::uint64_t number, const QString& words, bool good);

    World world_;
    QTimer pause_;
    QThreadPool pool_;
    std::uint64_t asked_ = 0;
    std::uint64_t shown_ = 0;
    bool busy_ = false;
};

}  // namespace hitos::window
