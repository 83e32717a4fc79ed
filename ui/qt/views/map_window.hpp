// SPDX-License-Identifier: GPL-3.0-or-later
// A window of its own for a whole grid map [T use cases 8.2.2.7 and 8.2.2.8].
#pragma once

#include <QDialog>
#include <memory>

#include "workers/map_builder.hpp"

namespace hitos::window {

class GridView;
class ViewSettings;
namespace Ui {
class MapWindow;
}

class MapWindow final : public QDialog {
    Q_OBJECT

  public:
    enum class Show {
        growth,  ///< the map as it grows
        result   ///< only when it is whole
    };

    /// `settings`: the layers are those of the other views.
    MapWindow(const QString& title, Show show, const ViewSettings& settings, QWidget* parent);
    ~MapWindow() override;

    MapBuilder& builder() { return builder_; }
    GridView& view() const;

  signals:
    void picture_wanted(hitos::window::GridView* view);

  private:
    void refresh();
    void finish();

    std::unique_ptr<Ui::MapWindow> ui_;
    MapBuilder builder_;
    Show show_;
};

}  // namespace hitos::window
