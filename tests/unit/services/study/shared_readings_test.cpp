// SPDX-License-Identifier: GPL-3.0-or-later
// What runs of a study read in common, and what they do not.
#include "study/shared_readings.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <optional>

#include "hitos/base/error.hpp"
#include "hitos/features/extraction_parameters.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/services/run/open_source.hpp"
#include "study_fixture.hpp"

namespace hitos {
namespace {

using study::SharedReadings;
using ::testing::HasSubstr;

constexpr std::size_t kPlenty = std::size_t{256} << 20;

class SharedReadingsTest : public StudyTest {
  protected:
    /// That counts how often its log is opened.
    Study counted(const std::string& out) {
        Study study = this->study(out);
        study.source.open = [this](const SourceParams&, std::uint64_t) {
            ++opened_;
            SourceParams source;
            source.file = log_.string();
            return open_source(source);
        };
        return study;
    }
    static StudyJob job_with(const Study& study, std::uint64_t seed = 1) {
        StudyJob job{0, seed, study.configuration};
        job.configuration.run.seed = seed;
        return job;
    }
    struct Shared {
        bool tour = false;
        bool features = false;
    };
    /// What two runs have in common.
    Shared shared(const Study& study, const StudyJob& a, const StudyJob& b) {
        opened_ = 0;
        SharedReadings readings(kPlenty, {});
        readings.expect(study, a);
        readings.expect(study, b);
        const SharedReadings::Use use_a(readings, study, a);
        const SharedReadings::Use use_b(readings, study, b);
        const auto parts_a = use_a.parts();
        const auto parts_b = use_b.parts();
        EXPECT_EQ(parts_a.extractor == nullptr, parts_b.extractor == nullptr);
        return {opened_ == 1, parts_b.extractor != nullptr};
    }
    /// The study's files, with what is kept limited.
    std::map<std::string, std::string> files_with(const Study& study, std::size_t bytes,
                                                  int threads = 1) {
        opened_ = 0;
        std::filesystem::remove_all(study.layout.folder);
        StudyOptions options;
        options.shared_bytes = bytes;
        options.threads = threads;
        run(study, options);
        return files(study.layout.folder.filename().string());
    }

    std::atomic<int> opened_ = 0;
};

/// Another value, allowed or not.
void change_log(const ConfigParameter& parameter, Configuracion& configuration) {
    ParameterFacts::Value value = parameter.get(configuration);
    if (parameter.type == ParameterFacts::Type::choice) {
        const auto other = std::ranges::find_if(parameter.choices, [&](const auto& choice) {
            return choice.word != std::get<std::string>(value);
        });
        value = other->word;
    } else if (auto* const text = std::get_if<std::string>(&value)) {
        text->push_back('x');
    } else if (auto* const real = std::get_if<double>(&value)) {
        *real += 1.0;
    } else {
        ++std::get<std::int64_t>(value);
    }
    parameter.put(configuration, value);
}

// Nothing is left out of what decides, whatever parameters there are.
TEST_F(SharedReadingsTest, RunsShareWhatNoParameterThatDiffersDecides) {
    const Study study = counted("out");
    const StudyJob job = job_with(study);
    EXPECT_TRUE(shared(study, job, job).features);
    for (const ConfigParameter& parameter : parameters()) {
        StudyJob other = job;
        change_log(parameter, other.configuration);
        const Shared common = shared(study, job, other);
        const bool source = parameter.table() == "source";
        const bool extraction = look_up(extraction_parameters(), parameter.key) != nullptr;
        EXPECT_EQ(common.tour, !source) << parameter.key;
        EXPECT_EQ(common.features, !source && !extraction) << parameter.key;
    }
}

TEST_F(SharedReadingsTest, SeedsCountWhereTheyDecide) {
    Study study = counted("out");
    EXPECT_TRUE(shared(study, job_with(study, 1), job_with(study, 2)).features);
    study.configuration.extraction.method = "ransac";
    EXPECT_TRUE(shared(study, job_with(study, 1), job_with(study, 2)).tour);
    EXPECT_FALSE(shared(study, job_with(study, 1), job_with(study, 2)).features);
    EXPECT_TRUE(shared(study, job_with(study, 2), job_with(study, 2)).features);
    study.source.seeded = [](const SourceParams&) { return true; };
    EXPECT_FALSE(shared(study, job_with(study, 1), job_with(study, 2)).tour);
    EXPECT_TRUE(shared(study, job_with(study, 2), job_with(study, 2)).tour);
}

TEST_F(SharedReadingsTest, StudiesOfOtherSettingsShareNothing) {
    const Study one = counted("one");
    for (const char* setting : {"", "other"}) {
        Study two = counted("two");
        two.setting = setting;
        opened_ = 0;
        SharedReadings readings(kPlenty, {});
        readings.expect(one, job_with(one));
        readings.expect(two, job_with(two));
        const StudyJob job_one = job_with(one);
        const StudyJob job_two = job_with(two);
        const SharedReadings::Use use_one(readings, one, job_one);
        const SharedReadings::Use use_two(readings, two, job_two);
        use_one.parts();
        use_two.parts();
        EXPECT_EQ(opened_, two.setting.empty() ? 1 : 2);
    }
}

TEST_F(SharedReadingsTest, ALogIsReadOnceHoweverManyThreadsAsk) {
    const auto alone = files_with(counted("out"), 0);
    EXPECT_EQ(opened_, 1 + 1 + 12) << "to see whether it opens, given up once, by each run";
    for (const int threads : {1, 2, 6}) {
        EXPECT_EQ(files_with(counted("out"), kPlenty, threads), alone);
        EXPECT_EQ(opened_, 1 + 1) << threads;
    }
}

TEST_F(SharedReadingsTest, AChangedLogIsNoticedThoughNobodyReadsItAgain) {
    Study study = counted("out");
    StudyOptions options;
    options.listener = [&](const StudyPlan&, std::size_t run, const StudyRecord&) {
        if (run == 4) folder_.put("small.log", small_log() + small_log());
    };
    EXPECT_THAT(test::message_of<FileError>([&] { run(study, options); }),
                HasSubstr("small.log: has changed while it was being worked on"));
    EXPECT_EQ(opened_, 1 + 1);
    const StudyOutcome anew = run(study);
    EXPECT_EQ(anew.reused, 0U);
    EXPECT_EQ(anew.records.front().scans, 62U) << "of the log as it is now";
}

// What is lost of a log stands in every table: a run that comes to its end has read the whole log.
TEST_F(SharedReadingsTest, DamageIsToldAsByRunsThatReadForThemselves) {
    folder_.put("small.log", "LASER 0 1\nODOM x\n" + small_log() + small_log() +
                                 "LASER 9 60\nODOM 9 9\nODOM 10 1 0\nODOM 11 y\n");
    const auto alone = files_with(counted("out"), 0);
    EXPECT_THAT(alone.at("quality.csv"), HasSubstr(",5,30,0,\"line 1: "));
    EXPECT_EQ(files_with(counted("out"), kPlenty), alone);
}

TEST_F(SharedReadingsTest, NothingIsKeptBeyondTheLimitOrTheLastRun) {
    const Study study = counted("out");
    const StudyJob job = job_with(study);
    const auto kept = [&](std::size_t most) {
        opened_ = 0;
        SharedReadings readings(most, {});
        readings.expect(study, job);
        readings.expect(study, job);
        std::size_t bytes = 0;
        {
            const SharedReadings::Use first(readings, study, job);
            first.parts();
            bytes = readings.bytes();
            EXPECT_LE(bytes, most);
            const SharedReadings::Use second(readings, study, job);
            second.parts();
            EXPECT_EQ(readings.bytes(), bytes);
        }
        EXPECT_EQ(readings.bytes(), 0U);
        return bytes;
    };
    const std::size_t all = kept(kPlenty);
    EXPECT_EQ(opened_, 1);
    EXPECT_EQ(kept(all), all);
    const std::size_t tour = kept(all - 1);
    EXPECT_GT(tour, sizeof(Point2) * 31 * 60);
    EXPECT_LT(tour, all) << "features do not fit";
    EXPECT_EQ(opened_, 1);
    EXPECT_EQ(kept(tour - 1), 0U);
    EXPECT_EQ(opened_, 3) << "given up once, then by each run";
    const auto alone = files_with(study, 0);
    for (const std::size_t most : {tour - 1, tour, all - 1}) {
        EXPECT_EQ(files_with(study, most, 2), alone) << most;
    }
}

TEST_F(SharedReadingsTest, TheLastRunThatNeedsATourReadsItForItself) {
    const Study study = counted("out");
    const StudyJob job = job_with(study);
    SharedReadings readings(kPlenty, {});
    readings.expect(study, job);
    const SharedReadings::Use use(readings, study, job);
    EXPECT_EQ(use.parts().extractor, nullptr);
    EXPECT_EQ(readings.bytes(), 0U);
}

TEST_F(SharedReadingsTest, AStoppedStudyReadsNothingAhead) {
    const Study study = counted("out");
    const StudyJob job = job_with(study);
    std::stop_source stop;
    stop.request_stop();
    SharedReadings readings(kPlenty, stop.get_token());
    readings.expect(study, job);
    readings.expect(study, job);
    const SharedReadings::Use use(readings, study, job);
    EXPECT_TRUE(use.parts().reader->next_scan());
    EXPECT_EQ(readings.bytes(), 0U);
}

/// A tour with some change of its odometry.
class ChangedTour : public TourReader {
  public:
    explicit ChangedTour(std::unique_ptr<TourReader> reader, double factor = 1.0)
        : reader_(std::move(reader)), factor_(factor) {}
    std::optional<Scan> next_scan() override { return reader_->next_scan(); }
    std::optional<Odometria> next_odometry() override {
        std::optional<Odometria> reading = reader_->next_odometry();
        if (reading) reading->twist.v *= factor_;
        return reading;
    }
    void restart() override { reader_->restart(); }
    std::unique_ptr<TourReader> reopen() const override {
        return std::make_unique<ChangedTour>(reader_->reopen(), factor_);
    }
    const ReadReport& report() const override { return reader_->report(); }
    std::optional<double> progress() const override { return reader_->progress(); }
    std::string name() const override { return reader_->name(); }
    std::string format() const override { return reader_->format(); }
    ReadOptions options() const override { return {}; }

  protected:
    std::unique_ptr<TourReader> reader_;

  private:
    double factor_;
};

/// A log on a medium that fails at its fifth scan.
class FailingTour final : public ChangedTour {
  public:
    using ChangedTour::ChangedTour;
    std::optional<Scan> next_scan() override {
        if (reader_->report().scans == 4) throw FileError("tape", verbatim("torn"));
        return reader_->next_scan();
    }
    std::unique_ptr<TourReader> reopen() const override {
        return std::make_unique<FailingTour>(reader_->reopen());
    }
};

TEST_F(SharedReadingsTest, EveryRunIsToldThatItsLogCannotBeRead) {
    for (const int threads : {1, 3}) {
        Study study = this->study("torn" + std::to_string(threads));
        study.source.open = [](const SourceParams& source, std::uint64_t) {
            return std::make_unique<FailingTour>(open_source(source));
        };
        StudyOptions options;
        options.threads = threads;
        const StudyOutcome outcome = run(study, options);
        EXPECT_EQ(outcome.failed, 12U);
        for (const StudyRecord& record : outcome.records) {
            EXPECT_EQ(record.problem.english(), "tape: torn");
        }
    }
}

// Each run changes the shared tour for itself.
TEST_F(SharedReadingsTest, WhatIsARunsOwnStaysItsOwn) {
    const auto with_change = [&](std::size_t bytes) {
        Study study = counted("out");
        study.setting = "faster with the seed";
        study.source.change = [](std::unique_ptr<TourReader> tour, const StudyJob& job) {
            const double factor = 1.0 + 0.1 * static_cast<double>(job.seed);
            return std::make_unique<ChangedTour>(std::move(tour), factor);
        };
        return files_with(study, bytes);
    };
    const auto alone = with_change(0);
    EXPECT_EQ(with_change(kPlenty), alone);
    EXPECT_EQ(opened_, 2);
    EXPECT_NE(alone.at("maps/dmax-0.02-p-2-s1.map"), alone.at("maps/dmax-0.02-p-2-s3.map"));
}

}  // namespace
}  // namespace hitos
