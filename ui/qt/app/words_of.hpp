// What the libraries say, in the language of the window.
#pragma once

#include <QString>
#include <exception>

#include "hitos/base/message.hpp"

namespace hitos::window {

/// In the context "Errors"; what has no translation is said in English. Any thread may ask.
QString words_of(const Message& message);
QString words_of(const std::exception& error);

}  // namespace hitos::window
