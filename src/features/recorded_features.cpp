// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/features/recorded_features.hpp"

#include <stdexcept>

namespace hitos {
namespace {

template <class Item>
std::size_t bytes_of(const std::vector<Item>& items) {
    return items.size() * sizeof(Item);
}

std::size_t bytes_of(const Observation& seen) {
    return sizeof(Observation) + bytes_of(seen.lines) + bytes_of(seen.corners) +
           bytes_of(seen.support) + bytes_of(seen.line_covariances) +
           bytes_of(seen.corner_covariances) + bytes_of(seen.identities) +
           bytes_of(seen.circle_radii_m);
}

}  // namespace

std::shared_ptr<const RecordedFeatures> record_features(const RecordedTour& tour,
                                                        Extractor& extractor,
                                                        const MayGrow& may_grow) {
    auto features = std::make_shared<RecordedFeatures>();
    Observation seen;
    for (const Scan& scan : tour.scans.items) {
        extractor.go_to(features->size());
        extractor.extract(scan, seen);
        if (!may_grow(bytes_of(seen))) return nullptr;
        features->push_back(seen);
    }
    return features;
}

void RecordedExtractor::extract(const Scan& scan, Observation& out) {
    const Observation& seen = features_->at(next_++);
    if (seen.time_s != scan.time_s) throw std::logic_error("features of another scan");
    out = seen;
}

}  // namespace hitos
