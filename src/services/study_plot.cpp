#include "study_plot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "hitos/capture/atomic_file.hpp"
#include "hitos/capture/error.hpp"
#include "text_input.hpp"

namespace hitos::study {
namespace {

namespace fs = std::filesystem;

/// One plot: a figure of each cell against the parameter.
struct Measure {
    const char* name;  ///< stem of its files
    const char* label;
    std::optional<Spread> StudyCell::*spread;
};

constexpr std::array kMeasures = {Measure{"error", "map error (m)", &StudyCell::error_m},
                                  Measure{"landmarks", "landmarks", &StudyCell::landmarks}};

std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) {
        if (c == '\'') result += '\'';
        result += c == '\n' ? ' ' : c;
    }
    return result + "'";
}

/// How the first parameter lies along x: by its number where each value is one, else place by
/// place with the values as words.
struct Abscissa {
    bool numbers = true;
    bool logarithmic = false;
    std::vector<double> positions;
    std::vector<std::string> words;
};

Abscissa abscissa_of(const StudyPlan::Axis& axis) {
    Abscissa x;
    for (const StudyValue& value : axis.values) {
        x.words.push_back(fmt::format("{}", fmt::join(value, "/")));
        const auto number = input::parse_number(x.words.back());
        if (value.size() != 1 || !number || !std::isfinite(*number)) x.numbers = false;
        x.positions.push_back(number.value_or(0.0));
    }
    if (!x.numbers) {
        for (std::size_t i = 0; i < x.positions.size(); ++i)
            x.positions[i] = static_cast<double>(i + 1);
        return x;
    }
    // Values such as 5, 10, 20 … 500 are meant by their ratios.
    constexpr double kWide = 20.0;
    const auto [least, greatest] = std::minmax_element(x.positions.begin(), x.positions.end());
    x.logarithmic = *least > 0.0 && *greatest >= kWide * *least;
    return x;
}

std::size_t curves(const StudyPlan& plan) {
    return plan.axes.size() < 2 ? 1 : plan.axes[1].values.size();
}

/// gnuplot's blocks: one for each curve, with two empty lines between.
std::string data_text(const StudyPlan& plan, std::span<const StudyCell> cells, const Abscissa& x,
                      const Measure& measure) {
    std::string text = "# x mean standard_deviation minimum maximum runs\n";
    std::vector<std::size_t> order(x.positions.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return x.positions[a] < x.positions[b]; });
    for (std::size_t curve = 0; curve < curves(plan); ++curve) {
        if (curve > 0) text += "\n\n";
        if (plan.axes.size() > 1) {
            text += fmt::format("# {} = {}\n", plan.axes[1].name,
                                fmt::join(plan.axes[1].values[curve], "/"));
        }
        for (const std::size_t i : order) {
            const auto& spread = cells[i * curves(plan) + curve].*measure.spread;
            if (!spread) {
                text += fmt::format("{} NaN NaN NaN NaN 0\n", x.positions[i]);
                continue;
            }
            text += fmt::format("{} {} {} {} {} {}\n", x.positions[i], spread->mean,
                                std::sqrt(spread->variance.value_or(0.0)), spread->minimum,
                                spread->maximum, spread->count);
        }
    }
    return text;
}

std::string axis_label(const StudyPlan::Axis& axis) {
    std::string units;
    for (const std::string& unit : axis.units) {
        if (!unit.empty()) units += (units.empty() ? "" : ", ") + unit;
    }
    return units.empty() ? axis.name : fmt::format("{} ({})", axis.name, units);
}

/// Leaves room at both ends; gnuplot's own range goes to whole decades where x is logarithmic.
std::string range(const Abscissa& x) {
    constexpr double kRoom = 0.04;
    const auto [least, greatest] = std::minmax_element(x.positions.begin(), x.positions.end());
    if (x.logarithmic) {
        const double room = std::pow(*greatest / *least, kRoom);
        return fmt::format("set logscale x\nset xrange [{:.6g}:{:.6g}]\n", *least / room,
                           *greatest * room);
    }
    const double span = *greatest - *least;
    const double room = span > 0.0 ? kRoom * span : std::max(1.0, std::abs(*least));
    return fmt::format("set xrange [{:.6g}:{:.6g}]\n", *least - room, *greatest + room);
}

/// Words, and the values of a logarithmic axis, stand at their places.
std::string tics(const Abscissa& x) {
    std::vector<std::string> marks;
    for (std::size_t i = 0; i < x.positions.size(); ++i) {
        marks.push_back(fmt::format("{} {}", quoted(x.words[i]), x.positions[i]));
    }
    return fmt::format("set xtics ({})\n", fmt::join(marks, ", "));
}

std::string script_text(const StudyLayout& layout, const StudyPlan& plan, const Abscissa& x,
                        const Measure& measure) {
    const std::string stem = layout.prefix + measure.name;
    std::string plot = "plot ";
    for (std::size_t curve = 0; curve < curves(plan); ++curve) {
        const std::string title = plan.axes.size() < 2
                                      ? "mean and standard deviation"
                                      : fmt::format("{} = {}", plan.axes[1].name,
                                                    fmt::join(plan.axes[1].values[curve], "/"));
        if (curve > 0) plot += ", \\\n     ";
        plot += fmt::format(
            "{} index {} using 1:2:3 with yerrorlines linewidth 1.5 pointtype 7 "
            "pointsize 0.7 title {}",
            quoted(stem + ".dat"), curve, quoted(title));
    }
    if (measure.spread == &StudyCell::landmarks) {
        plot += fmt::format(
            ", \\\n     {} with lines dashtype 2 linecolor 'black' title "
            "'in the reference'",
            plan.reference_lines + plan.reference_corners);
    }
    std::string text = fmt::format("# Draw again with: gnuplot {}.gp\n", stem);
    text += fmt::format("set xlabel {} noenhanced\n", quoted(axis_label(plan.axes[0])));
    text += fmt::format("set ylabel '{}'\n", measure.label);
    text += "set grid\nset key outside top center horizontal noenhanced\nset yrange [0:*]\n";
    text += range(x);
    if (x.logarithmic || !x.numbers) text += tics(x);
    text += "set xtics noenhanced\n";
    for (const auto& [extension, terminal] :
         {std::pair("png", "pngcairo size 900,600"), std::pair("svg", "svg size 900,600")}) {
        text += fmt::format("set terminal {}\nset output {}\n{}\n", terminal,
                            quoted(stem + "." + extension), plot);
    }
    return text + "unset output\n";
}

/// A folder for gnuplot to write in; what is whole in the end is moved out.
class Workshop {
  public:
    explicit Workshop(const fs::path& beside)
        : path_(beside / fmt::format(".hitos-{}-plots", ::getpid())) {
        std::error_code error;
        fs::remove_all(path_, error);
        fs::create_directory(path_, error);
        if (error) throw FileError(path_.string(), "cannot be made: " + error.message());
    }
    ~Workshop() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    Workshop(const Workshop&) = delete;
    Workshop& operator=(const Workshop&) = delete;
    const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

std::string read_all(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// Empty where gnuplot has run the script; else why not.
std::string run_gnuplot(const fs::path& folder, const std::string& script) {
    const fs::path said = folder / "gnuplot.out";
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, said.c_str(),
                                       O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    ::posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
    std::string program = "gnuplot";
    std::string argument = script;
    std::array<char*, 3> arguments{program.data(), argument.data(), nullptr};
    pid_t process = 0;
    const int error =
        ::posix_spawnp(&process, program.c_str(), &actions, nullptr, arguments.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    if (error == ENOENT) return "gnuplot is not installed (Debian: gnuplot-nox)";
    if (error != 0) return "gnuplot: " + std::generic_category().message(error);
    int status = 0;
    while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return "";
    const std::string output = read_all(said);
    return "gnuplot fails: " + std::string(input::trimmed(output).substr(0, 400));
}

}  // namespace

std::string write_plots(const StudyLayout& layout, const StudyPlan& plan,
                        std::span<const StudyCell> cells) {
    if (plan.axes.empty()) return "";
    const Abscissa x = abscissa_of(plan.axes[0]);
    std::string problem;
    const Workshop workshop(layout.folder);
    for (const Measure& measure : kMeasures) {
        const std::string stem = layout.prefix + measure.name;
        const std::string data = data_text(plan, cells, x, measure);
        const std::string script = script_text(layout, plan, x, measure);
        for (const fs::path& folder : {layout.folder, workshop.path()}) {
            write_file(folder / (stem + ".dat"), data);
            write_file(folder / (stem + ".gp"), script);
        }
        const bool any = std::any_of(cells.begin(), cells.end(), [&](const StudyCell& cell) {
            return (cell.*measure.spread).has_value();
        });
        std::string failure = any ? "" : fmt::format("no run gave a figure for {}", measure.name);
        if (failure.empty()) failure = run_gnuplot(workshop.path(), stem + ".gp");
        for (const char* extension : {".png", ".svg"}) {
            const fs::path picture = layout.folder / (stem + extension);
            if (failure.empty()) {
                write_file(picture, read_all(workshop.path() / (stem + extension)));
            } else {
                // One from an earlier time would not show these figures.
                std::error_code ignored;
                fs::remove(picture, ignored);
            }
        }
        if (problem.empty()) problem = failure;
    }
    return problem;
}

}  // namespace hitos::study
