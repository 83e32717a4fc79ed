// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared_readings.hpp"

#include "hitos/features/extraction_parameters.hpp"

namespace hitos::study {

SharedReadings::TourKey SharedReadings::tour_key(const Study& study, const StudyJob& job) {
    return {study.setting, job.configuration.source, study.source.seed_of(job)};
}

SharedReadings::FeaturesKey SharedReadings::features_key(const StudyJob& job) {
    const ExtractionParams& extraction = job.configuration.extraction;
    constexpr std::size_t kPrime = 1'000'003;
    std::size_t spread = 0;
    for (const Parameter<ExtractionParams>& parameter : extraction_parameters()) {
        spread = spread * kPrime ^ std::hash<ParameterFacts::Value>{}(parameter.get(extraction));
    }
    const std::uint64_t seed = draws_at_random(extraction) ? job.configuration.run.seed : 0;
    return {extraction, seed, spread * kPrime ^ seed};
}

std::size_t SharedReadings::Spread::operator()(const TourKey& key) const {
    constexpr std::size_t kPrime = 1'000'003;
    std::size_t spread = std::hash<std::string>{}(key.source.file);
    spread = spread * kPrime ^ std::hash<std::string>{}(key.source.world_set);
    spread = spread * kPrime ^ std::hash<std::uint64_t>{}(key.source.tour_seed);
    return spread * kPrime ^ std::hash<std::uint64_t>{}(key.seed);
}

void SharedReadings::expect(const Study& study, const StudyJob& job) {
    TourKey tour = tour_key(study, job);
    FeaturesKey features = features_key(job);
    const std::scoped_lock lock(mutex_);
    KeptTour& kept = tours_[std::move(tour)];
    ++kept.runs;
    ++kept.features[std::move(features)].runs;
}

std::size_t SharedReadings::bytes() const {
    const std::scoped_lock lock(mutex_);
    return bytes_;
}

bool SharedReadings::take(std::size_t bytes) {
    const std::scoped_lock lock(mutex_);
    if (stop_.stop_requested() || bytes > most_bytes_ - bytes_) return false;
    bytes_ += bytes;
    return true;
}

template <class Value>
typename SharedReadings::Kept<Value>::Pointer SharedReadings::once(
    Kept<Value>& kept, const std::function<typename Kept<Value>::Pointer(const MayGrow&)>& make) {
    const std::scoped_lock making(kept.making);
    if (kept.tried) return kept.value;
    {
        const std::scoped_lock lock(mutex_);
        if (kept.runs < 2) return nullptr;  // nobody to share it with
    }
    kept.tried = true;
    std::size_t taken = 0;
    try {
        kept.value = make([&](std::size_t bytes) {
            if (!take(bytes)) return false;
            taken += bytes;
            return true;
        });
    } catch (...) {
        kept.value = nullptr;  // whoever reads it for himself is told
    }
    const std::scoped_lock lock(mutex_);
    if (kept.value) {
        kept.bytes = taken;
    } else {
        bytes_ -= taken;
    }
    return kept.value;
}

template <class Value>
bool SharedReadings::is_over(Kept<Value>& kept) {
    if (--kept.runs > 0) return false;
    bytes_ -= kept.bytes;
    return true;
}

SharedReadings::Use::Use(SharedReadings& shared, const Study& study, const StudyJob& job)
    : shared_(shared),
      study_(study),
      job_(job),
      tour_key_(tour_key(study, job)),
      features_key_(features_key(job)) {
    const std::scoped_lock lock(shared_.mutex_);
    tour_ = &shared_.tours_.at(tour_key_);
    features_ = &tour_->features.at(features_key_);
}

SharedReadings::Use::~Use() {
    const std::scoped_lock lock(shared_.mutex_);
    if (shared_.is_over(*features_)) tour_->features.erase(features_key_);
    if (shared_.is_over(*tour_)) shared_.tours_.erase(tour_key_);
}

SharedReadings::Parts SharedReadings::Use::parts() const {
    const StudySource& source = study_.source;
    const auto tour = shared_.once<RecordedTour>(*tour_, [&](const MayGrow& may_grow) {
        return record_tour(*source.open_shared(job_), may_grow);
    });
    if (!tour) return {source.open_tour(job_), nullptr, false};
    Parts parts{source.changed(std::make_unique<RecordedReader>(tour), job_), nullptr, true};
    const auto features = shared_.once<RecordedFeatures>(*features_, [&](const MayGrow& may_grow) {
        const Configuracion& c = job_.configuration;
        return record_features(*tour, *make_extractor(c.extraction, c.run.seed), may_grow);
    });
    if (features) {
        parts.extractor = [features] { return std::make_unique<RecordedExtractor>(features); };
    }
    return parts;
}

}  // namespace hitos::study
