// SPDX-License-Identifier: GPL-3.0-or-later
// Clips for devices of shapes that know none.
#pragma once

#include <QPaintDevice>
#include <memory>

class QPaintEngine;

namespace hitos::window {

/// In front of a device that draws whatever a painter clips away, as QSvgGenerator does: only what
/// lies within the clip gets there. Lines, areas and pictures are cut by the rectangle around the
/// clip; a text stands as a whole where a part of it would be seen.
class ClippingDevice final : public QPaintDevice {
  public:
    /// `target` must live longer.
    explicit ClippingDevice(QPaintDevice& target);
    ~ClippingDevice() override;
    QPaintEngine* paintEngine() const override;

  protected:
    int metric(PaintDeviceMetric metric) const override;

  private:
    const QPaintDevice& target_;
    std::unique_ptr<QPaintEngine> engine_;
};

}  // namespace hitos::window
