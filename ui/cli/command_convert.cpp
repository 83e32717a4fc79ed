// SPDX-License-Identifier: GPL-3.0-or-later
// hitos-cli convert: from one log format to another, with odometry noise if wished.

#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <string>

#include "commands.hpp"
#include "damage.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/input_files.hpp"
#include "hitos/base/plural.hpp"
#include "hitos/base/process.hpp"
#include "hitos/capture/archivo.hpp"
#include "hitos/capture/log_format.hpp"
#include "hitos/capture/log_writer.hpp"
#include "hitos/services/results/results.hpp"
#include "hitos/services/run/open_source.hpp"
#include "hitos/simulation/drive/noisy_reader.hpp"
#include "hitos/workbench/configuration_choices.hpp"
#include "options.hpp"
#include "progress_line.hpp"
#include "report.hpp"

namespace hitos::cli {
namespace {

struct ConvertOptions {
    std::string log;
    SourceOptions source;
    std::string to;
    std::string out;
    double noise = 0.0;
    std::string noise_kind = "relative-sigma";
    std::uint64_t seed = 1;
    bool json = false;
};

void convert(const ConvertOptions& options) {
    const std::string target = checked_target_format(options.to, "--to");
    SourceParams source;
    source.file = input_named(options.log, "log");
    expect_used({}, options.source.topics, {source.file});
    options.source.choose(source);
    // What is written is mended by who reads it, where the format can say what is needed for it.
    source.read.mend = log_formats().find(target).ray_times ? Mend::nothing : Mend::rays;
    const std::filesystem::path out = options.out;
    check_apart({&out, 1}, log_files(source.file));
    const std::unique_ptr<TourReader> reader = make_noisy_reader(
        open_source(source), options.noise,
        parse_noise_kind(options.noise_kind, "--odometry-noise-kind"), options.seed);
    const auto writer = make_log_writer(target, options.out);

    ProgressLine line("scan");
    const ReadReport& report = reader->report();
    write_tour(*reader, *writer, [&] { line.show(report.scans, reader->progress()); });
    if (report.scans == 0) {
        throw FormatError(source.file, 0, verbatim("found no readable scan; nothing was written"));
    }
    writer->finish();
    line.finish(report.scans);
    Report said(options.json);
    said.say("{}: {}, {}\n{}", on_one_line(options.out), plural(report.scans, "scan"),
             plural(report.odometry, "odometry reading"), damage_text(report));
    said.object() = {{"file", options.out}, {"format", target}, {"scans", report.scans}};
    said.object()["log"] = parsed_object(to_json(report));
    said.end();
}

}  // namespace

void add_convert(CLI::App& program) {
    auto options = std::make_shared<ConvertOptions>();
    CLI::App* command = program.add_subcommand(
        "convert", "Write a log in another format, with noise on its odometry if wished");
    command
        ->add_option("log", options->log,
                     "Log file, plain or .gz, or ROS recording; - for standard input")
        ->required();
    add_source_options(*command, options->source);
    command->add_option("--to", options->to, writable_formats())->required();
    command->add_option("--out", options->out, "File to write; .gz compresses it")
        ->required()
        ->check(&complaint_of_output);
    command->add_option(
        "--odometry-noise", options->noise,
        "Level of the noise on v and w, 0 or more; the thesis uses 0.1 (default: 0, none)");
    command->add_option("--odometry-noise-kind", options->noise_kind,
                        noise_kind_choices() + " (default: relative-sigma)");
    command->add_option("--seed", options->seed, "Seed of the noise (default: 1)")
        ->check(&complaint_of_seed);
    add_report_option(*command, options->json);
    command->callback([options] { convert(*options); });
}

}  // namespace hitos::cli
