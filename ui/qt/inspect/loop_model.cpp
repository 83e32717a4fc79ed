// SPDX-License-Identifier: GPL-3.0-or-later
#include "loop_model.hpp"

#include <array>
#include <cstddef>
#include <utility>

#include "look/parameter_text.hpp"
#include "look/words_of.hpp"

namespace hitos::window {

QString verdict_words(LoopVerdict verdict) {
    constexpr std::array kWords{QT_TRANSLATE_NOOP("LoopVerdict", "Closed"),
                                QT_TRANSLATE_NOOP("LoopVerdict", "Fits badly"),
                                QT_TRANSLATE_NOOP("LoopVerdict", "Corridor"),
                                QT_TRANSLATE_NOOP("LoopVerdict", "Looked through"),
                                QT_TRANSLATE_NOOP("LoopVerdict", "Said once"),
                                QT_TRANSLATE_NOOP("LoopVerdict", "No edge"),
                                QT_TRANSLATE_NOOP("LoopVerdict", "Bends the graph"),
                                QT_TRANSLATE_NOOP("LoopVerdict", "Refused by hand")};
    return translated("LoopVerdict", kWords.at(static_cast<std::size_t>(verdict)));
}

LoopModel::LoopModel(QObject* parent)
    : FiguresModel({tr("Scan"), tr("Earlier"), tr("Verdict"), tr("Off"), tr("Score"), tr("Overlap"),
                    tr("Looked through"), "χ²", tr("Way between"), tr("Moved"), tr("Weight")},
                   parent) {}

void LoopModel::set_loops(std::vector<RunLoop> loops) {
    change(static_cast<int>(loops.size()), [&] { loops_ = std::move(loops); });
}

std::optional<double> LoopModel::figure(int row, int column) const {
    const RunLoop& loop = loops_[static_cast<std::size_t>(row)];
    const LoopRecord& record = loop.record;
    switch (column) {
        case score:
            return record.score;
        case overlap:
            return record.overlap;
        case through:
            return record.seen_through;
        case chi:
            return record.chi_square;
        case way:
            return record.way_m;
        case moved:
            return loop.closed() ? std::optional(record.move_m) : std::nullopt;
        case weight:
            return record.weight;
        default:
            return loop.error_m;
    }
}

QVariant LoopModel::key(int row, int column) const {
    const LoopRecord& record = loops_[static_cast<std::size_t>(row)].record;
    switch (column) {
        case scan:
            return QVariant::fromValue<qulonglong>(record.scan);
        case earlier:
            return QVariant::fromValue<qulonglong>(record.earlier);
        case verdict:
            return verdict_words(record.verdict);
        default:
            return figure(row, column).value_or(-1.0);
    }
}

QString LoopModel::text(int row, int column) const {
    const LoopRecord& record = loops_[static_cast<std::size_t>(row)].record;
    switch (column) {
        case scan:
            return QString::number(record.scan + 1);
        case earlier:
            return QString::number(record.earlier + 1);
        case verdict:
            return verdict_words(record.verdict);
        default:
            break;
    }
    const std::optional<double> value = figure(row, column);
    if (!value) return QStringLiteral("–");
    if (column == way || column == moved || column == error) return metre_words(*value);
    return QString::number(*value, 'f', column == chi ? 1 : 2);
}

bool LoopModel::strong(int row) const {
    return loops_[static_cast<std::size_t>(row)].closed();
}

}  // namespace hitos::window
