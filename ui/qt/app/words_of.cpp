#include "words_of.hpp"

#include <QCoreApplication>

#include "hitos/base/error.hpp"

namespace hitos::window {

QString words_of(const Message& message) {
    return QString::fromStdString(message.translated([](const char* text) {
        return QCoreApplication::translate("Errors", text).toStdString();
    }));
}

QString words_of(const std::exception& error) {
    return words_of(message_of(error));
}

}  // namespace hitos::window
