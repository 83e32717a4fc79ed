// What the document of a reproduction says in words.
#pragma once

#include <string>

namespace hitos {

/// How the experiments were done.
std::string reproduction_introduction();
/// Where the outcome differs from the thesis's, and why.
std::string reproduction_remarks();

}  // namespace hitos
