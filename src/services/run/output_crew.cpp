#include "output_crew.hpp"

#include <algorithm>
#include <system_error>
#include <thread>

#include "hitos/base/error.hpp"

namespace hitos {
namespace {

/// Each may hold a grid, of which there are three.
constexpr int kMostWorkers = 3;

int workers(int threads) {
    if (threads == 0) threads = static_cast<int>(std::thread::hardware_concurrency());
    return std::clamp(threads, 1, kMostWorkers);
}

}  // namespace

std::vector<Message> OutputCrew::write(std::span<const RunOutput* const> outputs, int threads) {
    reasons_.assign(outputs.size(), Message());
    failed_.assign(outputs.size(), 0);
    told_of_ = 0;
    for (next_ = 0; next_ < outputs.size() && outputs[next_]->essential; ++next_) {
        tell(*outputs[next_], outputs.size());
        reasons_[next_] = outputs[next_]->write(finished_, folder_);
    }
    const bool alone = work_together(outputs, workers(threads));
    if (broken_) std::rethrow_exception(broken_);
    for (std::size_t place = 0; place < outputs.size(); ++place) {
        if (failed_[place] != 0 && !alone) write_one(outputs, place);
    }
    return std::move(reasons_);
}

bool OutputCrew::work_together(std::span<const RunOutput* const> outputs, int workers) {
    std::vector<std::jthread> others;
    try {
        for (int i = 1; i < workers; ++i) {
            others.emplace_back([this, outputs] { work(outputs); });
        }
    } catch (const std::exception&) {  // fewer, then
    }
    work(outputs);
    return others.empty();
}

void OutputCrew::work(std::span<const RunOutput* const> outputs) {
    try {
        for (std::size_t place = next_++; place < outputs.size() && !stopped_; place = next_++) {
            tell(*outputs[place], outputs.size());
            write_one(outputs, place);
        }
    } catch (...) {  // of the observer, and what no message could be made of
        const std::scoped_lock lock(mutex_);
        if (!broken_) broken_ = std::current_exception();
        stopped_ = true;
    }
}

void OutputCrew::write_one(std::span<const RunOutput* const> outputs, std::size_t place) {
    const RunOutput& output = *outputs[place];
    try {
        failed_[place] = 0;
        reasons_[place] = output.write(finished_, folder_);
    } catch (const std::exception& error) {  // of a library too
        failed_[place] = 1;
        for (const std::string& file : output.files(finished_)) {
            std::error_code ignored;
            std::filesystem::remove(folder_ / file, ignored);
        }
        reasons_[place] = message_of(error);
    }
}

void OutputCrew::tell(const RunOutput& output, std::size_t all) {
    if (!told_) return;
    const std::scoped_lock lock(mutex_);
    told_({output.files(finished_).front(), ++told_of_, all});
}

}  // namespace hitos
