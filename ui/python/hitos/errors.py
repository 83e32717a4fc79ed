# SPDX-License-Identifier: GPL-3.0-or-later
"""What can go wrong in Hitos, as types."""


class Error(Exception):
    """Whatever bad data, bad arguments or the file system cause; its text says what was found,
    where, what was expected and what to do."""


class FileError(Error, OSError):
    """A file that cannot be opened, read, written or renamed; `path` names it."""

    path = ""

    def __str__(self):
        return str(self.args[0]) if self.args else ""


class FormatError(Error, ValueError):
    """A file whose content is not what it should be; `path` names it ("" where it is not known) and
    `line` is the line, from 1, or 0 where no line applies."""

    path = ""
    line = 0


class ConfigurationError(Error, ValueError):
    """A parameter that does not exist, or a value that it cannot take; `key` names it."""

    key = ""
