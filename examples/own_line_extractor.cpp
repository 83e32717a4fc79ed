// SPDX-License-Identifier: GPL-3.0-or-later
// A line method of one's own: lines grow point by point as long as a fit through all of their
// points stays within dmax of the newest one (the incremental method). It is chosen like any other,
// by features.method.
//
// usage: own_line_extractor LOG
#include <cmath>
#include <cstdio>
#include <exception>

#include "hitos/features/line_fit.hpp"
#include "hitos/features/line_methods.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/services/run/algoritmo.hpp"
#include "hitos/workbench/open_tour.hpp"

namespace {

class Incremental final : public hitos::MetodoExtraccionRectas {
  public:
    explicit Incremental(const hitos::ExtractionParams& params) : params_(params) {}

    void extract_lines(const hitos::Scan& scan, hitos::Observation& out) override {
        for (std::size_t run = 0; run < scan.run_starts.size(); ++run) {
            std::size_t first = scan.run_starts[run];
            const std::size_t end = scan.run_end(run);
            while (first + 2 <= end) {
                std::size_t last = first + 2;  // behind the line's last point
                while (last < end && fits(scan, first, last + 1)) ++last;
                keep(scan, first, last, out);
                first = last;
            }
        }
    }

  private:
    using Points = std::span<const hitos::Point2>;

    static Points points(const hitos::Scan& scan, std::size_t first, std::size_t end) {
        return Points(scan.points).subspan(first, end - first);
    }

    bool fits(const hitos::Scan& scan, std::size_t first, std::size_t end) const {
        const hitos::Recta line = hitos::fit_least_squares(points(scan, first, end));
        const double away = hitos::signed_distance(line, scan.points[end - 1]);
        return std::abs(away) < params_.split_merge.dmax_m;
    }

    void keep(const hitos::Scan& scan, std::size_t first, std::size_t end,
              hitos::Observation& out) const {
        const Points support = points(scan, first, end);
        const double length =
            std::hypot(support.back().x - support.front().x, support.back().y - support.front().y);
        if (length < params_.lines.min_length_m ||
            support.size() < static_cast<std::size_t>(params_.lines.min_points)) {
            return;
        }
        out.lines.push_back({hitos::fit_least_squares(support),
                             static_cast<std::uint32_t>(out.support.size()),
                             static_cast<std::uint32_t>(support.size())});
        out.support.insert(out.support.end(), support.begin(), support.end());
    }

    hitos::ExtractionParams params_;
};

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return std::fputs("usage: own_line_extractor LOG\n", stderr), 2;
    try {
        hitos::line_methods().add(
            {{"incremental", "Incremental", "grows lines point by point", {"split_merge.dmax"}},
             [](const hitos::ExtractionParams& params, std::uint64_t) {
                 return std::make_unique<Incremental>(params);
             }});
        hitos::Configuracion configuration;
        configuration.source.file = argv[1];
        hitos::find_parameter("features.method").set(configuration, "incremental");
        hitos::find_parameter("split_merge.dmax").set(configuration, "0.03");
        hitos::Algoritmo run(configuration, hitos::open_tour(configuration.source));
        while (run.step()) {
        }
        std::printf("%s: %zu landmarks in %zu scans\n",
                    run.configuration().extraction.method.c_str(), run.filter().best_map().size(),
                    run.steps());
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "own_line_extractor: %s\n", error.what());
        return 1;
    }
}
