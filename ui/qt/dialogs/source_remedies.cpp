#include "source_remedies.hpp"

#include <fmt/format.h>

#include <QRegularExpression>
#include <QString>
#include <algorithm>
#include <cmath>
#include <optional>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/capture/archivo.hpp"

namespace hitos::window {
namespace {

const ConfigParameter* source_parameter(const std::string& key) {
    const auto table = parameters();
    const auto found = std::ranges::find(table, key, &ConfigParameter::key);
    return found == table.end() || found->table() != "source" ? nullptr : &*found;
}

bool can_be(const ConfigParameter& parameter, const std::string& value) {
    const bool number = QString("+-.0123456789").contains(QChar::fromLatin1(value.front()));
    const bool described = parameter.type == ConfigParameter::Type::text && !number;
    if (described && parameter.key != kOdometryAxesKey) return false;
    try {
        parameter.value_from(value);
        return true;
    } catch (const Error&) {
        return false;
    }
}

/// What is advised of a tour that was read with a delay or a scale is to be added to it.
std::string on_top_of(const std::string& present, const std::string& advised,
                      std::string_view key) {
    const bool delay = key == "source.scan_delay";
    const std::optional<double> before = input::parse_number(present);
    const std::optional<double> more = input::parse_number(advised);
    if (!before || !more || !(delay || key.ends_with("_scale"))) return advised;
    constexpr double kSteps = 1e6;  // no digits that nobody has measured
    const double sum = delay ? *before + *more : *before * *more;
    return fmt::format("{}", std::round(sum * kSteps) / kSteps);
}

}  // namespace

std::vector<SourceRemedy> remedies_of(const TourFinding& finding, const SourceParams& now) {
    static const QRegularExpression option(
        R"(--(?:set (source\.\w+)=|([a-z]+(?:-[a-z]+)*) )([^\s;:()]*[^\s;:(),.]))");
    Configuracion read;
    read.source = now;
    std::vector<SourceRemedy> remedies;
    const QString words = QString::fromStdString(finding.remedy.english());
    for (auto match = option.globalMatch(words); match.hasNext();) {
        const QRegularExpressionMatch said = match.next();
        const QString key = said.captured(1).isEmpty()
                                ? "source." + said.captured(2).replace('-', '_')
                                : said.captured(1);
        const ConfigParameter* parameter = source_parameter(key.toStdString());
        // What is added at a second of the tour is the clock's, and of two such tables none is a
        // sum.
        if (said.captured(3).contains('@')) parameter = &find_parameter(kScanClockKey);
        if (parameter == nullptr) continue;
        if (parameter->key == kScanClockKey && !parameter->text(read).empty()) continue;
        const std::string value =
            on_top_of(parameter->text(read), said.captured(3).toStdString(), parameter->key);
        if (can_be(*parameter, value)) remedies.push_back({parameter, value});
    }
    return remedies;
}

}  // namespace hitos::window
