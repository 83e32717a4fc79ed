// SPDX-License-Identifier: GPL-3.0-or-later
// Layouts that go by the room there is.
#pragma once

#include <QBoxLayout>
#include <QLayout>
#include <vector>

namespace hitos::window {

/// One beside the other, as words are: what does not fit goes to the next line.
class FlowLayout final : public QLayout {
  public:
    /// Without margins.
    explicit FlowLayout(QWidget* parent, int spacing);
    ~FlowLayout() override;

    void addItem(QLayoutItem* item) override { items_.push_back(item); }
    int count() const override { return static_cast<int>(items_.size()); }
    QLayoutItem* itemAt(int index) const override;
    QLayoutItem* takeAt(int index) override;
    Qt::Orientations expandingDirections() const override { return {}; }
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override { return arranged({0, 0, width, 0}, false); }
    QSize sizeHint() const override { return minimumSize(); }
    QSize minimumSize() const override;
    void setGeometry(const QRect& place) override;

  private:
    /// The height that they need; `move` puts them there.
    int arranged(const QRect& place, bool move) const;

    std::vector<QLayoutItem*> items_;
};

/// From now on what is beside each other in the widget's layout is one above the other while the
/// widget is narrower than that.
void stack_when_narrow(QWidget& widget, QBoxLayout& sides, int width);

}  // namespace hitos::window
