// SPDX-License-Identifier: GPL-3.0-or-later
// A log format of one's own: an entry in the table of formats, and every part of Hitos reads it.
//
// The format: `P time x y theta` is a pose of the robot by odometry, `S time r0 r1 … r180` a scan
// of 181 ranges in centimetres over the half circle ahead; a range of 0 is no return.
//
// usage: own_format LOG
#include <cmath>
#include <cstdio>
#include <exception>
#include <sstream>

#include "hitos/base/error.hpp"
#include "hitos/capture/conversor.hpp"
#include "hitos/capture/fuente.hpp"
#include "hitos/capture/log_format.hpp"
#include "hitos/services/run/algoritmo.hpp"
#include "hitos/workbench/open_tour.hpp"

namespace {

class CentimetreConversor final : public hitos::Conversor {
  public:
    explicit CentimetreConversor(const hitos::ReadOptions& options) : options_(options) {}

    std::optional<hitos::Scan> scan(const hitos::RawLine& line) override {
        std::istringstream in{std::string(line.text.substr(1))};
        hitos::Scan scan;
        scan.line = line.number;
        scan.fan = {-hitos::kPi / 2, hitos::kPi / 2, 181, options_.max_range_m, {}};
        if (!(in >> scan.time_s))
            throw hitos::FormatError("", line.number, hitos::verbatim("found no time"));
        bool run_open = false;
        for (std::uint32_t ray = 0; ray < scan.fan.count; ++ray) {
            double centimetres = 0.0;
            if (!(in >> centimetres)) {
                throw hitos::FormatError("", line.number, hitos::verbatim("expected 181 ranges"));
            }
            const double range = centimetres / 100.0;
            const bool hit =
                range > 0.0 && (options_.max_range_m == 0.0 || range < options_.max_range_m);
            if (hit) {
                if (!run_open) {
                    scan.run_starts.push_back(static_cast<std::uint32_t>(scan.points.size()));
                }
                const double angle = scan.fan.angle_rad(ray);
                scan.points.push_back({range * std::cos(angle), range * std::sin(angle)});
                scan.rays.push_back(ray);
            }
            run_open = hit;
        }
        return scan;
    }

    std::optional<hitos::OdometryRecord> odometry(const hitos::RawLine& line) override {
        std::istringstream in{std::string(line.text.substr(1))};
        hitos::OdometryRecord record;
        hitos::Pose pose;
        record.line = line.number;
        if (!(in >> record.time_s >> pose.x >> pose.y >> pose.theta)) {
            throw hitos::FormatError("", line.number, hitos::verbatim("expected time x y theta"));
        }
        record.pose_odom_robot = pose;
        return record;
    }

  private:
    hitos::ReadOptions options_;
};

hitos::LogFormat centimetres() {
    hitos::LogFormat format{{"centimetres", "Centimetres", "ranges in centimetres"}};
    format.claims = [](std::string_view line) {
        return line.starts_with("P ") || line.starts_with("S ");
    };
    format.classify = [](std::string_view line) {
        if (line.starts_with("S ")) return hitos::LineKind::scan;
        return line.starts_with("P ") ? hitos::LineKind::odometry : hitos::LineKind::damaged;
    };
    format.make_conversor =
        [](const hitos::Fuente&,
           const hitos::ReadOptions& options) -> std::unique_ptr<hitos::Conversor> {
        return std::make_unique<CentimetreConversor>(options);
    };
    return format;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return std::fputs("usage: own_format LOG\n", stderr), 2;
    try {
        hitos::log_formats().add(centimetres());
        hitos::Configuracion configuration;
        configuration.source.file = argv[1];
        hitos::Algoritmo run(configuration, hitos::open_tour(configuration.source));
        while (run.step()) {
        }
        std::printf("%s: %zu landmarks in %zu scans, %zu damaged lines\n",
                    run.reader().format().c_str(), run.filter().best_map().size(), run.steps(),
                    run.report().skipped);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "own_format: %s\n", error.what());
        return 1;
    }
}
