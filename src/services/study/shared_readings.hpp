// SPDX-License-Identifier: GPL-3.0-or-later
// What runs read in common: the tours, and the features of their scans.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <unordered_map>
#include <utility>

#include "hitos/capture/recorded_tour.hpp"
#include "hitos/features/recorded_features.hpp"
#include "hitos/services/study/study.hpp"

namespace hitos::study {

/// Keeps each tour, and the features of each extraction from it, from the first of several runs
/// that need it to the last, as long as all together stay within a limit. What does not fit, or
/// cannot be read, or is for one run only, every run reads and extracts for itself, and is told for
/// itself what is wrong with it. Thread-safe.
class SharedReadings {
    /// All that a tour depends on, but for files, which are looked at after every run.
    struct TourKey {
        std::string setting;
        SourceParams source;
        std::uint64_t seed = 0;
        friend bool operator==(const TourKey&, const TourKey&) = default;
    };
    /// All that features depend on beside the tour.
    struct FeaturesKey {
        ExtractionParams extraction;
        std::uint64_t seed = 0;
        std::size_t spread = 0;  ///< made of the others
        friend bool operator==(const FeaturesKey&, const FeaturesKey&) = default;
    };
    template <class Value>
    struct Kept {
        using Pointer = std::shared_ptr<const Value>;
        std::size_t runs = 0;  ///< that are not over
        std::size_t bytes = 0;
        std::mutex making;  ///< guards the two below; whoever finds it locked waits for them
        bool tried = false;
        Pointer value;  ///< null where it is not kept
    };
    /// That keys are equal is for the structs to say; these only spread them.
    struct Spread {
        std::size_t operator()(const TourKey& key) const;
        std::size_t operator()(const FeaturesKey& key) const { return key.spread; }
    };
    struct KeptTour : Kept<RecordedTour> {
        std::unordered_map<FeaturesKey, Kept<RecordedFeatures>, Spread> features;
    };

  public:
    /// What one run is made of.
    struct Parts {
        std::unique_ptr<TourReader> reader;
        std::function<std::unique_ptr<Extractor>()> extractor;  ///< null: the configuration's
        bool shared = false;  ///< whether other runs are given what was read
    };

    /// One run that was expected, from its begin to its end: it needs nothing after that.
    class Use {
      public:
        Use(SharedReadings& shared, const Study& study, const StudyJob& job);
        ~Use();
        Use(const Use&) = delete;
        Use& operator=(const Use&) = delete;

        /// Waits where another thread is at making them. Throws what opening the tour throws.
        Parts parts() const;

      private:
        SharedReadings& shared_;
        const Study& study_;
        const StudyJob& job_;
        const TourKey tour_key_;
        const FeaturesKey features_key_;
        KeptTour* tour_;
        Kept<RecordedFeatures>* features_;
    };

    /// Nothing more is read once `stop` is asked for.
    SharedReadings(std::size_t most_bytes, std::stop_token stop)
        : most_bytes_(most_bytes), stop_(std::move(stop)) {}

    /// A run is to come.
    void expect(const Study& study, const StudyJob& job);
    /// What is kept now.
    std::size_t bytes() const;

  private:
    static TourKey tour_key(const Study& study, const StudyJob& job);
    static FeaturesKey features_key(const StudyJob& job);
    template <class Value>
    typename Kept<Value>::Pointer once(
        Kept<Value>& kept,
        const std::function<typename Kept<Value>::Pointer(const MayGrow&)>& make);
    bool take(std::size_t bytes);
    /// One run less; whether it was the last.
    template <class Value>
    bool is_over(Kept<Value>& kept);

    std::size_t most_bytes_;
    std::stop_token stop_;

    mutable std::mutex mutex_;  // guards all below
    std::size_t bytes_ = 0;
    std::unordered_map<TourKey, KeptTour, Spread> tours_;
};

}  // namespace hitos::study
