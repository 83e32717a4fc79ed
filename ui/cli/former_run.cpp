// SPDX-License-Identifier: GPL-3.0-or-later
#include "former_run.hpp"

#include <fmt/chrono.h>
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <chrono>
#include <ctime>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/base/file_exchange.hpp"
#include "hitos/base/message.hpp"
#include "hitos/base/parameter.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/services/results/kept_run.hpp"
#include "hitos/services/results/results.hpp"

namespace hitos::cli {
namespace {

/// Of a file, by the clock on the wall; empty where it cannot be asked.
std::string written_at(const std::filesystem::path& file) {
    std::error_code problem;
    const auto time = std::filesystem::last_write_time(file, problem);
    if (problem) return {};
    const auto system = std::chrono::file_clock::to_sys(time);
    const std::time_t seconds =
        std::chrono::duration_cast<std::chrono::seconds>(system.time_since_epoch()).count();
    std::tm local{};
    localtime_r(&seconds, &local);
    return fmt::format(", written {:%Y-%m-%d %H:%M}", local);
}

[[noreturn]] void refuse(const std::filesystem::path& folder, const std::string& held,
                         const char* place = "their") {
    throw FileError(folder.string(),
                    verbatim(fmt::format("holds {}; choose another folder, or say --replace to put "
                                         "this run in {} place",
                                         held, place)));
}

/// The first few of many.
void name_one(std::vector<std::string>& named, std::string one) {
    constexpr std::size_t kMostNamed = 3;
    if (named.size() > kMostNamed) return;
    named.push_back(named.size() == kMostNamed ? "…" : std::move(one));
}

void refuse_fewer_files(const std::filesystem::path& folder, const UnaskedFiles& unasked) {
    if (unasked.files.empty()) return;
    std::vector<std::string> names;
    for (const std::string& file : unasked.files) name_one(names, file);
    std::vector<std::string> ways(unasked.options.begin(), unasked.options.end());
    if (!unasked.words.empty())
        ways.push_back(fmt::format("--write {}", fmt::join(unasked.words, ",")));
    throw FileError(
        folder.string(),
        verbatim(fmt::format("holds {} of this run, which would be gone: ask for them "
                             "again ({}), choose another folder, or say --replace to do "
                             "without them",
                             fmt::join(names, ", "), fmt::join(ways, " "))));
}

}  // namespace

void refuse_another_run(const std::filesystem::path& folder, const Configuracion& configuration,
                        std::span<const std::string> also, std::span<const std::string> options) {
    if (const auto name = somebodys_file(folder, also))
        refuse(folder, fmt::format("{}, which is of no run", *name), "its");
    const std::filesystem::path summary = folder / "summary.json";
    if (!is_there(summary)) return;  // one that cannot be looked at is there
    const std::string written = written_at(summary);
    Configuracion former;
    try {
        former = ArchivoConfiguracion::read(folder / "config.cfg");
    } catch (const Error& error) {
        refuse(folder,
               fmt::format("the results of a run{} that cannot be compared with this one: {}",
                           written, error.what()));
    }
    if (!same_log(former, configuration)) {
        refuse(folder, fmt::format("the results of a run of another source, {}{}",
                                   on_one_line(former.source.file), written));
    }
    std::vector<std::string> changes;
    for (const ConfigParameter* parameter : differences(former, configuration))
        name_one(changes, fmt::format("{} {}", parameter->key, parameter->text(former)));
    if (!changes.empty()) {
        refuse(folder,
               fmt::format("the results of another run of {}{}, with {}",
                           on_one_line(former.source.file), written, fmt::join(changes, ", ")));
    }
    refuse_fewer_files(folder, unasked_files(folder, also, options));
}

bool tell_kept(const std::filesystem::path& folder) {
    if (!holds_finished_run(folder)) return false;
    fmt::print(
        stderr,
        "nothing is written: {} keeps the results of a run to its tour's end{}, and this one "
        "was stopped before; --out with another folder keeps what a stopped run has\n",
        on_one_line(folder.string()), written_at(folder / "summary.json"));
    return true;
}

}  // namespace hitos::cli
