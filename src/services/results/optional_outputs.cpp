// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/results/optional_outputs.hpp"

#include <algorithm>

#include "hitos/base/error.hpp"
#include "hitos/base/parameter.hpp"
#include "hitos/base/text_input.hpp"
#include "run_outputs.hpp"

namespace hitos {
namespace {

constexpr std::string_view kAll = "all";

[[noreturn]] void refuse(std::string_view name, const std::vector<OptionalOutput>& outputs,
                         const std::string& option) {
    std::vector<std::string_view> names;
    std::vector<std::string_view> words{kAll};
    for (const OptionalOutput& output : outputs) {
        words.push_back(output.word);
        names.push_back(output.word);
        names.insert(names.end(), output.files.begin(), output.files.end());
    }
    const auto near = parameter_detail::near_keys(name, names);
    const Message all = verbatim(parameter_detail::joined(words, ", "));
    throw ConfigError(option,
                      near.empty()
                          ? message(HITOS_TEXT("Errors",
                                               "found \"%1\", which is no file of a run that can "
                                               "be asked for; there are %2"),
                                    name, all)
                          : message(HITOS_TEXT("Errors",
                                               "found \"%1\", which is no file of a run that can "
                                               "be asked for; did you mean %2? There are %3"),
                                    name, either(near), all));
}

}  // namespace

std::vector<OptionalOutput> optional_outputs() {
    std::vector<OptionalOutput> outputs;
    for (const RunOutput& output : run_outputs()) {
        if (!output.word.empty()) outputs.push_back({output.word, output.names, output.purpose});
    }
    return outputs;
}

std::vector<std::string> chosen_outputs(std::string_view list, const std::string& option) {
    const std::vector<OptionalOutput> outputs = optional_outputs();
    std::vector<std::string> chosen;
    const auto choose = [&chosen](const OptionalOutput& output) {
        if (std::ranges::count(chosen, output.word) == 0) chosen.push_back(output.word);
    };
    for (const std::string_view name : input::listed(list)) {
        if (name == kAll) {
            std::ranges::for_each(outputs, choose);
            continue;
        }
        const auto found = std::ranges::find_if(outputs, [name](const OptionalOutput& output) {
            return output.word == name || std::ranges::count(output.files, name) > 0;
        });
        if (found == outputs.end()) refuse(name, outputs, option);
        choose(*found);
    }
    return chosen;
}

}  // namespace hitos
