#include "view_tool.hpp"

namespace hitos::window {

ViewTool::~ViewTool() = default;

}  // namespace hitos::window
