// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the plan of a benchmark.
#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "hitos/base/error.hpp"
#include "hitos/base/folder_entries.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/base/text_limits.hpp"
#include "hitos/workbench/benchmark.hpp"
#include "hitos/workbench/presets.hpp"
#include "hitos/workbench/shipped_data.hpp"
#include "toml_entry.hpp"

namespace hitos {
namespace {

constexpr const char* kFolder = "data/benchmarks";
constexpr const char* kEnding = ".toml";
constexpr std::size_t kMostRows = 10'000;
constexpr int kMostCopies = 100;

/// Where the paths of a plan lie.
class Places {
  public:
    Places(const std::filesystem::path& plan, std::filesystem::path tours)
        : folders_{std::move(tours), plan.parent_path()} {}

    /// Where it is; where it is nowhere, where it would be looked for first.
    std::string found(const std::string& file) const {
        if (file.empty() || std::filesystem::path(file).is_absolute()) return file;
        std::string first;
        for (const std::filesystem::path& folder : folders_) {
            if (folder.empty() && &folder == &folders_.front()) continue;
            const std::filesystem::path path = folder / file;
            std::error_code ignored;
            if (std::filesystem::exists(path, ignored)) return path.string();
            if (first.empty()) first = path.string();
        }
        return first;
    }

  private:
    std::vector<std::filesystem::path> folders_;
};

bool is_shipped_world(const std::string& name) {
    return std::ranges::count(shipped_worlds(), name) > 0;
}

/// "logs/intel.log.gz" is intel.
std::string stem_of(const std::string& file) {
    const std::string name = std::filesystem::path(file).filename().string();
    return name.substr(0, name.find('.'));
}

BenchmarkTour tour_of(TomlEntry& entry, const Places& places) {
    BenchmarkTour tour;
    const std::string file = entry.text("file");
    tour.name = entry.value_or("name", stem_of(file), "a text in quotes");
    // Whatever else has that name where the program is started.
    tour.file = is_shipped_world(file) ? needed_file("data/worlds/" + file + ".toml").string()
                                       : places.found(file);
    const auto path = [&](std::string_view key) {
        return places.found(entry.value_or(key, std::string(), "a path in quotes"));
    };
    tour.map = path("map");
    tour.trajectory = path("trajectory");
    tour.relations = path("relations");
    tour.digest = entry.value_or("digest", std::string(), "a text in quotes");
    tour.address = entry.value_or("address", std::string(), "a text in quotes");
    tour.noise = entry.value_or("noise", 0.0, "a level of 0 or more");
    if (!(tour.noise >= 0.0) || !std::isfinite(tour.noise)) {
        entry.refuse("noise", "a level of 0 or more");
    }
    const std::string kind =
        entry.value_or("noise_kind", std::string("relative-sigma"), "a text in quotes");
    const auto known = std::ranges::find(kOdometryNoiseKinds, kind, &OdometryNoiseFacts::word);
    if (known == kOdometryNoiseKinds.end()) {
        entry.refuse("noise_kind", noise_kind_choices().c_str());
    }
    tour.noise_kind = static_cast<OdometryNoiseKind>(known - kOdometryNoiseKinds.begin());
    tour.copies = static_cast<int>(entry.whole_or("copies", 0, 0, kMostCopies));
    // A world is driven anew by every run as it is; and a map lies about the first scan.
    if (tour.copies > 0 && (is_world_file(tour.file) || !tour.map.empty()))
        entry.refuse("copies", "0 of a world, and of a tour with a map");
    tour.settings = entry.texts("set", "a list of texts, each \"key=value\"");
    return tour;
}

BenchmarkAlgorithm algorithm_of(TomlEntry& entry, const Places& places) {
    BenchmarkAlgorithm algorithm;
    algorithm.name = entry.text("name");
    const bool configured = entry.has("config");
    if (configured && entry.has("preset")) entry.refuse("preset", "either it or config");
    if (configured) {
        algorithm.preset.clear();
        algorithm.config = places.found(entry.text("config"));
    } else {
        algorithm.preset =
            entry.value_or("preset", std::string(kAutoPreset), "a preset's word in quotes");
        if (algorithm.preset != kAutoPreset &&
            std::ranges::count(presets(), algorithm.preset, &Preset::word) == 0) {
            entry.refuse("preset", ("auto or one of " + preset_words()).c_str());
        }
    }
    algorithm.settings = entry.texts("set", "a list of texts, each \"key=value\"");
    return algorithm;
}

BenchmarkPeer peer_of(TomlEntry& entry, const Places& places) {
    return {entry.text("name"), entry.text("tour"), places.found(entry.text("trajectory"))};
}

/// One thing made of every [[name]]; none where there is no such list.
template <class Thing>
std::vector<Thing> list_of(const std::string& file, const toml::table& document,
                           std::string_view name, const Places& places,
                           Thing (*made)(TomlEntry&, const Places&)) {
    std::vector<Thing> things;
    const toml::node* node = document.get(name);
    if (node == nullptr) return things;
    if (!node->is_array_of_tables()) {
        throw FormatError(file, node->source().begin.line, HITOS_TEXT("Errors", "%1: expected %2"),
                          name, fmt::format("tables, each beginning with [[{}]]", name));
    }
    for (const toml::node& one : *node->as_array()) {
        TomlEntry entry(file, *one.as_table());
        things.push_back(made(entry, places));
        entry.end();
        const std::string& latest = things.back().name;
        // A peer has a row for each of its tours.
        const bool twice = !std::is_same_v<Thing, BenchmarkPeer> &&
                           std::ranges::count(things, latest, &Thing::name) > 1;
        if (latest.empty() || twice) {
            throw FormatError(file, one.source().begin.line,
                              HITOS_TEXT("Errors", "%1: expected %2"), name,
                              fmt::format("a name that no other has; found \"{}\"", latest));
        }
    }
    return things;
}

BenchmarkPlan plan_of(const std::string& file, const toml::table& document, const Places& places) {
    BenchmarkPlan plan;
    TomlEntry entry(file, document);
    for (const char* list : {"tour", "algorithm", "peer"}) entry.has(list);
    plan.title = entry.value_or("title", stem_of(file), "a text in quotes");
    plan.runs = static_cast<int>(entry.whole_or("runs", 5, 1, StudyPlan::kMostRuns));
    plan.first_seed =
        static_cast<std::uint64_t>(entry.whole_or("first_seed", 1, 0, 1'000'000'000'000));
    entry.end();
    plan.tours = list_of<BenchmarkTour>(file, document, "tour", places, tour_of);
    plan.algorithms =
        list_of<BenchmarkAlgorithm>(file, document, "algorithm", places, algorithm_of);
    plan.peers = list_of<BenchmarkPeer>(file, document, "peer", places, peer_of);
    const auto expect = [&](bool good, std::string_view name, const std::string& expected) {
        if (!good)
            throw FormatError(file, 0, HITOS_TEXT("Errors", "%1: expected %2"), name, expected);
    };
    expect(!plan.tours.empty(), "tour", "one [[tour]] at least");
    expect(!plan.algorithms.empty(), "algorithm", "one [[algorithm]] at least");
    expect(plan.tours.size() * plan.algorithms.size() <= kMostRows, "algorithm",
           fmt::format("{} rows at the most, tours by algorithms", kMostRows));
    std::set<std::pair<std::string, std::string>> rows;
    for (const BenchmarkPeer& peer : plan.peers) {
        expect(rows.emplace(peer.tour, peer.name).second &&
                   std::ranges::count(plan.algorithms, peer.name, &BenchmarkAlgorithm::name) == 0,
               "peer",
               fmt::format("a name that no other row of the tour has; found \"{}\"", peer.name));
        expect(std::ranges::count(plan.tours, peer.tour, &BenchmarkTour::name) > 0, "peer",
               fmt::format("the name of a tour; found \"{}\"", peer.tour));
    }
    return plan;
}

}  // namespace

BenchmarkPlan read_benchmark_plan(const std::filesystem::path& path,
                                  const std::filesystem::path& tours) {
    const std::string file = path.string();
    const std::string text = input::read_text(path, input::kLargestSettings);
    try {
        return plan_of(file, toml::parse(input::checked_toml(text, file)), Places(path, tours));
    } catch (const toml::parse_error& error) {
        throw FormatError(file, error.source().begin.line,
                          verbatim(std::string(error.description())));
    }
}

std::vector<std::string> shipped_benchmarks() {
    std::vector<std::string> names;
    std::error_code none;
    for (const auto& entry : folder_entries(shipped_file(kFolder), none)) {
        if (entry.path().extension() == kEnding) names.push_back(entry.path().stem().string());
    }
    std::ranges::sort(names);
    return names;
}

std::filesystem::path find_benchmark(const std::string& name) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(name, ignored) ||
        name.find_first_of("/.") != std::string::npos) {
        return name;
    }
    const std::vector<std::string> names = shipped_benchmarks();
    if (std::ranges::count(names, name) == 0) {
        throw FileError(name,
                        HITOS_TEXT("Errors",
                                   "is neither a file nor a benchmark that comes with "
                                   "Hitos; those are %1"),
                        fmt::format("{}", fmt::join(names, ", ")));
    }
    return shipped_file(kFolder) / (name + kEnding);
}

}  // namespace hitos
