#include "hitos/simulation/noisy_source.hpp"

#include <deque>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "hitos/capture/normalized_text.hpp"
#include "hitos/capture/procesador.hpp"

namespace hitos {
namespace {

class NoisySource final : public Fuente {
  public:
    NoisySource(std::unique_ptr<Fuente> source, const OdometryNoise& noise, ReadOptions options)
        : fresh_noise_(noise),
          noise_(noise),
          options_(options),
          odometry_(source->reopen(), options),
          scans_(std::move(source), options) {}

    LogFormat format() const override { return LogFormat::normalized; }

    std::optional<RawLine> read_scan_line() override {
        const std::optional<Scan> scan = scans_.next_scan();
        collect_damage();
        if (!scan) return std::nullopt;
        scan_text_.clear();
        append_normalized(scan_text_, *scan);
        return RawLine{scan_text_, scan->line};
    }

    std::optional<RawLine> read_odometry_line() override {
        const std::optional<Odometria> reading = odometry_.next_odometry();
        if (!reading) return std::nullopt;
        odometry_text_.clear();
        append_normalized(odometry_text_, noise_(*reading));
        return RawLine{odometry_text_, reading->line};
    }

    std::optional<double> progress() const override { return scans_.fuente().progress(); }
    std::string name() const override { return scans_.fuente().name(); }

    std::optional<std::pair<std::uint64_t, std::string>> take_damage() override {
        if (damage_.empty()) return std::nullopt;
        auto first = std::move(damage_.front());
        damage_.pop_front();
        return first;
    }

    std::unique_ptr<Fuente> reopen() const override {
        return std::make_unique<NoisySource>(scans_.fuente().reopen(), fresh_noise_, options_);
    }

  private:
    /// Hands on what the inner readers left out since the last call. Lines that neither cursor
    /// could read are counted by the one that reads scans, as everywhere.
    void collect_damage() {
        for (auto& [reader, told] :
             {std::tie(scans_, told_scans_), std::tie(odometry_, told_odometry_)}) {
            const ReadReport& report = reader.report();
            for (; told < report.skipped; ++told) {
                const bool known = told < report.examples.size();
                damage_.emplace_back(known ? report.examples[told].line : 0,
                                     known ? report.examples[told].reason : "damaged line");
            }
        }
    }

    OdometryNoise fresh_noise_;  // at the beginning of the tour
    OdometryNoise noise_;
    ReadOptions options_;
    Procesador odometry_;
    Procesador scans_;
    std::string scan_text_;
    std::string odometry_text_;
    std::deque<std::pair<std::uint64_t, std::string>> damage_;
    std::uint64_t told_scans_ = 0;
    std::uint64_t told_odometry_ = 0;
};

}  // namespace

std::unique_ptr<Fuente> make_noisy_source(std::unique_ptr<Fuente> source, double level,
                                          OdometryNoiseKind kind, std::uint64_t seed,
                                          bool logged_velocities) {
    // The greatest range is for the reader of this source to apply.
    return std::make_unique<NoisySource>(std::move(source), OdometryNoise(level, kind, seed),
                                         ReadOptions{0.0, logged_velocities});
}

}  // namespace hitos
