#include "damage.hpp"

#include <fmt/format.h>

namespace hitos::cli {

std::string damage_text(const ReadReport& report) {
    std::string text;
    if (report.skipped > 0) {
        const ReadReport::Skip first =
            report.examples.empty() ? ReadReport::Skip{} : report.examples.front();
        text += fmt::format("{} damaged line{} skipped; line {}: {}\n", report.skipped,
                            report.skipped == 1 ? " was" : "s were", first.line,
                            first.reason.english());
    }
    if (report.stamps_backwards > 0) {
        text +=
            fmt::format("{} time stamps lie before the one before them; the log's order was kept\n",
                        report.stamps_backwards);
    }
    return text;
}

}  // namespace hitos::cli
