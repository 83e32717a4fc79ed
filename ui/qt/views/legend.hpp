// SPDX-License-Identifier: GPL-3.0-or-later
// What a view draws: a chip a layer, which switches it.
#pragma once

#include <QWidget>
#include <vector>

class QToolButton;

namespace hitos::window {

class ViewSettings;

/// As many lines of chips as its width asks for; where it is narrow they are signs alone. Layers
/// that are off by default have a chip while they are on; the last chip has all of them.
class Legend final : public QWidget {
    Q_OBJECT

  public:
    enum class Of { scan, grid };

    explicit Legend(QWidget* parent = nullptr);
    /// Once.
    void set_up(const ViewSettings& settings, Of of);
    /// Whether the view shows the world's frame, without which it draws no path.
    void set_world_frame(bool on);

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    struct Chip {
        QToolButton* button;
        bool by_default;
        bool of_world;  ///< not drawn in the robot's frame
    };
    QToolButton* add_button();
    void refresh();

    std::vector<Chip> chips_;
    bool world_frame_ = true;
};

}  // namespace hitos::window
