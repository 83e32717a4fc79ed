// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/workbench/source_inspection.hpp"

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/capture/archivo.hpp"
#include "hitos/workbench/open_tour.hpp"

namespace hitos {

bool asks_for_topics(const std::exception& error, const ReadOptions& read) {
    const auto* wrong = dynamic_cast<const ConfigError*>(&error);
    if (wrong == nullptr) return false;
    return (wrong->key() == kScanTopicKey && input::trimmed(read.scan_topic).empty()) ||
           (wrong->key() == kOdomTopicKey && input::trimmed(read.odom_topic).empty());
}

SourceInspection inspect_source(const SourceParams& source, const InspectProgress& progress) {
    SourceInspection found;
    try {
        const std::unique_ptr<TourReader> reader = open_tour(source);
        found.tour = inspect_tour(*reader, progress);
    } catch (const ConfigError& error) {
        if (!asks_for_topics(error, source.read)) throw;
        found.choice = error.message();
        found.tour.format = recording_format(source.file)->word;
    }
    found.doubt = doubt_of_going_on(source);
    found.topics = topics_of(source.file);
    found.first_lines = found.topics.empty() ? first_lines_of(source.file) : lines_of(found.topics);
    return found;
}

}  // namespace hitos
