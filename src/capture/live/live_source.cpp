// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/capture/live_source.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <exception>
#include <span>
#include <string>
#include <utility>

#include "byte_stream.hpp"
#include "hitos/base/translatable.hpp"
#include "hitos/capture/archivo.hpp"
#include "hitos/capture/procesador.hpp"
#include "live/foxglove_receiver.hpp"
#include "live/received_file.hpp"
#include "recordings/mcap_ops.hpp"
#include "recordings/recording.hpp"
#include "regular_file.hpp"

namespace hitos {
namespace {

constexpr int kWaitMilliseconds = 20;

/// What has come; nothing where nothing has yet, 0 bytes at the end. Throws FileError.
std::optional<std::size_t> read_if_any(int descriptor, std::span<char> out) {
    pollfd event{descriptor, POLLIN, 0};
    if (::poll(&event, 1, kWaitMilliseconds) <= 0) return std::nullopt;
    const ssize_t got = ::read(descriptor, out.data(), out.size());
    if (got >= 0) return static_cast<std::size_t>(got);
    if (errno == EINTR || errno == EAGAIN) return std::nullopt;
    throw FileError("/dev/stdin", HITOS_TEXT("Errors", "cannot be read: %1"),
                    system_message(errno));
}

/// The bytes up to the end of the last whole line.
std::uint64_t whole_lines(const std::filesystem::path& path, std::uint64_t size) {
    const RegularFile file(path);
    std::array<char, 4096> block{};
    while (size > 0) {
        const std::uint64_t begin = size - std::min<std::uint64_t>(size, block.size());
        const std::size_t got = file.read_at(begin, std::span(block).first(size - begin));
        const std::string_view text(block.data(), got);
        if (const std::size_t at = text.rfind('\n'); at != std::string_view::npos)
            return begin + at + 1;
        size = begin;
    }
    return 0;
}

}  // namespace

LiveSource::LiveSource(const std::filesystem::path& file) : file_(file) {
    if (is_world_file(file)) {
        throw FileError(file.string(),
                        HITOS_TEXT("Errors", "is a world; a world is simulated, not followed"));
    }
    growth_ = std::make_shared<FileGrowth>(file);
}

LiveSource::LiveSource(std::unique_ptr<ReceivedFile> received, Receive receive)
    : LiveSource(received->path()) {
    received_ = std::move(received);
    receiver_ = std::jthread([this, receive = std::move(receive)](const std::stop_token& stop) {
        try {
            receive(stop, *this);
        } catch (const FileError& error) {
            const std::scoped_lock lock(mutex_);
            problem_ = error;
        } catch (const std::exception& error) {
            const std::scoped_lock lock(mutex_);
            problem_ = FileError(file_.string(), message_of(error));
        }
        growth_->end();
    });
}

LiveSource::~LiveSource() {
    end();
}

bool LiveSource::holds_something() const {
    return !received_ || received_->holds_something();
}

void LiveSource::replace_former() {
    if (received_) received_->replace();
}

std::filesystem::path LiveSource::former() const {
    return received_ ? received_->former() : std::filesystem::path();
}

bool LiveSource::give_back() {
    end();
    return received_ && received_->give_back();
}

std::unique_ptr<LiveSource> LiveSource::of_pipe(int descriptor, const std::filesystem::path& name,
                                                bool replace, const GoesOn& goes_on) {
    std::string first;
    while (first.size() < kMcapMagic.size()) {
        std::array<char, kInputBytes> block{};
        const auto got = read_if_any(descriptor, block);
        if (got == std::size_t{0}) break;
        if (got) first.append(block.data(), *got);
        if (!goes_on()) return nullptr;
    }
    if (first.empty()) {
        throw FileError("/dev/stdin", HITOS_TEXT("Errors",
                                                 "ended before anything came; expected a "
                                                 "log from the program before the |"));
    }
    std::filesystem::path file = name;
    file += begins_mcap(first) ? ".mcap" : ".log";
    const auto receive = [=](const std::stop_token& stop, LiveSource& source) {
        source.received_->append(first, true);
        std::array<char, kInputBytes> block{};
        while (!stop.stop_requested()) {
            const auto got = read_if_any(descriptor, block);
            if (got == std::size_t{0}) return;
            if (got) source.received_->append(std::span(block).first(*got), true);
        }
    };
    auto received = std::make_unique<ReceivedFile>(file, replace);
    return std::unique_ptr<LiveSource>(new LiveSource(std::move(received), receive));
}

std::unique_ptr<LiveSource> LiveSource::of_server(const std::string& url,
                                                  const std::filesystem::path& name, bool replace,
                                                  std::chrono::seconds patience,
                                                  const GoesOn& goes_on) {
    std::shared_ptr<FoxgloveReceiver> receiver;
    try {
        receiver = std::make_shared<FoxgloveReceiver>(url, patience, goes_on);
    } catch (const ConnectionError&) {
        if (goes_on()) throw;
    }
    if (!receiver || !goes_on()) return nullptr;
    std::filesystem::path file = name;
    file += ".mcap";
    const auto receive = [=](const std::stop_token& stop, LiveSource& source) {
        receiver->receive(
            stop,
            [&](std::string_view bytes) {
                // More than what describes it.
                source.received_->append(bytes, receiver->came());
            },
            [&](Message news) {
                const std::scoped_lock lock(source.mutex_);
                source.news_.push_back(std::move(news));
            });
    };
    auto received = std::make_unique<ReceivedFile>(file, replace);
    std::unique_ptr<LiveSource> source(new LiveSource(std::move(received), receive));
    source->server_ = receiver;
    return source;
}

std::vector<RecordedTopic> LiveSource::topics() const {
    return server_ ? server_->topics() : std::vector<RecordedTopic>{};
}

LinkState LiveSource::link() const {
    return server_ ? server_->link() : LinkState{};
}

std::vector<Message> LiveSource::take_news() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(news_, {});
}

void LiveSource::end() {
    const std::scoped_lock lock(ending_);
    if (receiver_.joinable()) {
        receiver_.request_stop();
        receiver_.join();
    }
    growth_->end();
}

std::optional<FileError> LiveSource::problem() const {
    const std::scoped_lock lock(mutex_);
    return problem_ ? problem_ : growth_->problem();
}

LiveSource::Opening LiveSource::opening_now(std::string_view format, ReadOptions options,
                                            std::size_t scans) const {
    Opening now;
    now.bytes = growth_->size();
    if (recording_format(file_) == nullptr && !growth_->ended())
        now.bytes = whole_lines(file_, now.bytes);
    options.opening_bytes = std::max<std::uint64_t>(now.bytes, 1);
    options.growth = nullptr;
    Procesador tour(open_log(file_, format, options)->opening(), options);
    while (now.scans < scans && tour.next_scan()) ++now.scans;
    while (now.readings < scans && tour.next_odometry()) ++now.readings;
    return now;
}

std::optional<LiveSource::Opening> LiveSource::wait_for_opening(
    std::string_view format, const ReadOptions& options, std::size_t scans,
    const std::function<bool(const Opening&)>& told) {
    constexpr std::chrono::milliseconds kLook(50);
    Opening opening;
    std::optional<std::uint64_t> looked_at;
    for (;;) {
        std::exception_ptr failure;
        const bool over = growth_->ended();
        if (!over && !holds_something()) {
            opening.problem = marked(HITOS_TEXT("Errors", "nothing has come yet"));
        } else if (over || looked_at != growth_->size()) {
            looked_at = growth_->size();
            try {
                opening = opening_now(format, options, scans);
            } catch (const FormatError& error) {
                failure = std::current_exception();
                opening.problem = error.problem();
            } catch (const ConfigError& error) {
                // A topic that was asked for may not have spoken yet.
                if (error.key() != kScanTopicKey && error.key() != kOdomTopicKey) throw;
                failure = std::current_exception();
                opening.problem = error.message();
                opening.to_choose = error.key() == kScanTopicKey ? options.scan_topic.empty()
                                                                 : options.odom_topic.empty();
            }
        }
        if (!told(opening)) return std::nullopt;
        if (over && failure) std::rethrow_exception(failure);  // else more may make sense of it
        if (over || opening.scans >= scans) return opening;
        std::this_thread::sleep_for(kLook);
    }
}

}  // namespace hitos
