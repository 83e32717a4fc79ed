// SPDX-License-Identifier: GPL-3.0-or-later
// Manual pages as troff reads them: man(7), groff_man(7).
#pragma once

#include <string>
#include <string_view>

namespace hitos::manual {

/// The text such that troff prints it as it stands: backslashes and hyphens of code, dots and
/// quotes that would begin a request.
std::string roff(std::string_view text);

std::string bold(std::string_view text);
std::string italic(std::string_view text);

/// ".TH NAME SECTION": what stands at the top and the foot of every page. Without a date, so that
/// the same sources give the same page.
std::string roff_title(std::string_view name, int section);

/// ".SH HEADING", in capitals.
std::string roff_section(std::string_view heading);

/// A paragraph that hangs below its tag, which is roff already.
std::string roff_item(std::string_view tag, std::string_view text);

/// Lines as they stand.
std::string roff_verbatim(std::string_view lines);

/// Roff of a page of prose: `## Headings`, paragraphs, lists of `- ` and code indented by four
/// columns; **bold**, *italic* and `code` within a line. Nothing else of Markdown is known.
std::string roff_of_prose(std::string_view markdown);

}  // namespace hitos::manual
