// SPDX-License-Identifier: GPL-3.0-or-later
// Names of objects, by which style sheets, tests and recorded sessions find them.
#pragma once

#include <QAnyStringView>

namespace hitos::window {

/// The object itself, which has that name from then on.
template <class Object>
Object* named(Object* object, QAnyStringView name) {
    object->setObjectName(name);
    return object;
}

}  // namespace hitos::window
