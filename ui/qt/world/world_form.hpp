// SPDX-License-Identifier: GPL-3.0-or-later
// Robot, laser, odometry and tour of a world in one form.
#pragma once

#include <QDialog>
#include <vector>

#include "dialogs/parameter_field.hpp"
#include "hitos/simulation/text/world_text.hpp"

class QGridLayout;
class QLabel;

namespace hitos::window {

/// Made from world_keys(). It can be left by OK only when every value and all of them together are
/// possible.
class WorldForm final : public QDialog {
    Q_OBJECT

  public:
    WorldForm(WorldText text, QWidget* parent);

    /// As accepted.
    const WorldText& text() const { return text_; }

    void accept() override;

  private:
    void add_group(std::string_view group, const QString& title, QGridLayout* rows, QWidget* box);

    WorldText text_;
    QLabel* verdict_ = nullptr;
    std::vector<FieldOf<World>*> fields_;
};

}  // namespace hitos::window
