// SPDX-License-Identifier: GPL-3.0-or-later
// Reads and writes configurations as commented TOML text.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "hitos/services/configuration/configuracion.hpp"

namespace hitos {

/// The file of a configuration (TOML), read and written [T 9.2.6].
class ArchivoConfiguracion {
  public:
    /// The defaults with the file's values over them. Throws FileError where it cannot be read and
    /// FormatError, with the line, for bad TOML, unknown keys (naming near ones), wrong types and
    /// values out of range; all mistakes of the file in one message. A log that it names by a
    /// relative path is looked for beside the file, then from the current folder.
    static Configuracion read(const std::filesystem::path& path);

    /// The changes by hand of a graph (registration.edits) from a configuration file that has
    /// nothing else. Throws what read() throws, and FormatError where it has.
    static std::string read_edits(const std::filesystem::path& path);
    /// Such a file, with `title` as its comment. Throws ConfigError where the changes are none.
    static std::string edits_text(const std::string& title, std::string_view edits);

    /// As read(), from text; `name` stands in messages.
    static Configuracion parse(std::string_view text, const std::string& name);

    /// Every parameter, group by group, each with its meaning, unit, range and default as a
    /// comment. Reading it back gives an equal configuration, to the last bit.
    static std::string to_text(const Configuracion& configuration);

    /// Writes to_text() atomically: a failed write leaves the file that was there. The log is named
    /// relative to the file where it lies beside or below it, else by its whole path.
    /// `folder`: where somebody will put the file; empty: it stays where it is written.
    static void write(const Configuracion& configuration, const std::filesystem::path& path,
                      const std::filesystem::path& folder = {});
};

}  // namespace hitos
