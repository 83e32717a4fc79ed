// Robot, laser, odometry and tour of a world in one form.
#pragma once

#include <QDialog>
#include <vector>

#include "dialogs/parameter_field.hpp"
#include "hitos/simulation/world.hpp"

class QGridLayout;

namespace hitos::window {

/// Made from world_keys(). It can be left by OK only when every value is possible.
class WorldForm final : public QDialog {
    Q_OBJECT

  public:
    WorldForm(const World& world, QWidget* parent);

    /// As accepted.
    const World& world() const { return world_; }

    void accept() override;

  private:
    void add_group(std::string_view group, const QString& title, QGridLayout* rows, QWidget* box);

    World world_;
    std::vector<FieldOf<World>*> fields_;
};

}  // namespace hitos::window
