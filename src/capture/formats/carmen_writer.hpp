// SPDX-License-Identifier: GPL-3.0-or-later
// The writer of CARMEN logs.
#pragma once

#include <filesystem>
#include <memory>

#include "hitos/capture/log_writer.hpp"

namespace hitos {

std::unique_ptr<LogWriter> make_carmen_writer(const std::filesystem::path& path);

}  // namespace hitos
