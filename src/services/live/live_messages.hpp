// SPDX-License-Identifier: GPL-3.0-or-later
// Snapshots as messages of Foxglove's schemas in JSON. Lengths in tenths of millimetres, which is
// less than any laser tells.
#pragma once

#include <string>

#include "live_channels.hpp"

namespace hitos::live {

std::string run_message(const LiveState& state);
std::string tf_message(const LiveState& state);
std::string pose_message(const LiveState& state);
std::string path_message(const LiveState& state);
std::string particles_message(const LiveState& state);
std::string covariance_message(const LiveState& state);
std::string landmarks_message(const LiveState& state);
std::string loops_message(const LiveState& state);
std::string scan_message(const LiveState& state);
/// Of a great grid several cells together are one, as dark as the darkest that is known.
std::string grid_message(const LiveState& state);

}  // namespace hitos::live
