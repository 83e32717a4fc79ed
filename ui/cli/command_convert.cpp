// hitos-cli convert: from one log format to another, with odometry noise if wished.

#include <fmt/core.h>

#include <memory>
#include <optional>
#include <string>

#include "commands.hpp"
#include "hitos/base/error.hpp"
#include "hitos/capture/archivo.hpp"
#include "hitos/capture/log_writer.hpp"
#include "hitos/capture/procesador.hpp"
#include "hitos/simulation/odometry_noise.hpp"
#include "options.hpp"
#include "progress_line.hpp"

namespace hitos::cli {
namespace {

struct ConvertOptions {
    std::string log;
    std::string format = "auto";
    std::string to;
    std::string out;
    double noise = 0.0;
    std::string noise_kind = "relative-sigma";
    std::uint64_t seed = 1;
};

/// Whether the reading belongs before the scan in the written file. A scan whose line carries
/// odometry goes by line: stamps may jitter there.
bool belongs_before(const Odometria& reading, const Scan& scan) {
    return scan.carries_odometry ? reading.line <= scan.line : reading.time_s <= scan.time_s;
}

void convert(const ConvertOptions& options) {
    const LogFormat target = parse_format(options.to, "--to");
    if (target == LogFormat::automatic) {
        throw ConfigError("--to", "found \"auto\", expected player, radish, normalized or carmen");
    }
    Procesador reader(open_log(options.log, parse_format(options.format, "--format")));
    OdometryNoise noise(options.noise, parse_noise_kind(options.noise_kind), options.seed);
    const auto writer = make_log_writer(target, options.out);

    ProgressLine line("scans");
    std::optional<Odometria> reading = reader.next_odometry();
    while (const auto scan = reader.next_scan()) {
        for (; reading && belongs_before(*reading, *scan); reading = reader.next_odometry()) {
            writer->write(noise(*reading));
        }
        writer->write(*scan);
        line.show(reader.report().scans, reader.fuente().progress());
    }
    for (; reading; reading = reader.next_odometry()) writer->write(noise(*reading));
    const ReadReport& report = reader.report();
    if (report.scans == 0) {
        throw FormatError(options.log, 0, "found no readable scan; nothing was written");
    }
    writer->finish();
    line.finish(report.scans);
    fmt::print("{}: {} scans, {} odometry readings", options.out, report.scans, report.odometry);
    if (report.skipped > 0) fmt::print(", {} damaged lines left out", report.skipped);
    fmt::print("\n");
}

}  // namespace

void add_convert(CLI::App& program) {
    auto options = std::make_shared<ConvertOptions>();
    CLI::App* command = program.add_subcommand(
        "convert", "Write a log in another format, with noise on its odometry if wished");
    command->add_option("log", options->log, "Log file, plain or .gz")->required();
    command->add_option("--format", options->format,
                        "auto, player, radish, normalized or carmen (default: auto)");
    command->add_option("--to", options->to, "player, radish, normalized or carmen")->required();
    command->add_option("--out", options->out, "File to write; .gz compresses it")->required();
    command->add_option("--odometry-noise", options->noise,
                        "Level of the noise on v and w; the thesis uses 0.1 (default: 0, none)");
    command->add_option(
        "--odometry-noise-kind", options->noise_kind,
        "relative-sigma: sigma = level |v| (default); variance: variance = level |v|");
    command->add_option("--seed", options->seed, "Seed of the noise (default: 1)");
    command->callback([options] { convert(*options); });
}

}  // namespace hitos::cli
