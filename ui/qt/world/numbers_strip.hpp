// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of what is drawn or chosen, to be typed.
#pragma once

#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "hitos/simulation/text/world_editing.hpp"

class QLabel;
class QLineEdit;

namespace hitos::window {

class NumbersStrip final : public QWidget {
    Q_OBJECT

  public:
    explicit NumbersStrip(QWidget* parent);

    /// Shows what there is; the fields can be typed into.
    void show_numbers(const std::vector<ItemNumber>& numbers);
    /// Fields for numbers that are not there yet; they are empty until they are typed.
    void ask_for(const std::vector<ItemNumber>& numbers);
    /// What is typed at that place; nothing where it is empty or no number.
    std::optional<double> typed(std::size_t place) const;
    /// Begins to type into the first field.
    void begin(const QString& text);

  signals:
    /// Return was pressed in the field, or it was left with another number, where it shows one.
    void entered(std::size_t place, double value);
    /// Another text stands in a field that asks.
    void edited();
    /// Return was pressed in a field that asks.
    void finished();
    /// Escape was pressed.
    void left();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    static constexpr std::size_t kMost = 3;
    void lay_out(const std::vector<ItemNumber>& numbers, bool asks);
    void take(std::size_t place);

    std::array<QLabel*, kMost> names_{};
    std::array<QLineEdit*, kMost> fields_{};
    std::array<QLabel*, kMost> units_{};
    std::vector<ItemNumber> shown_;
    bool asks_ = false;
};

}  // namespace hitos::window
