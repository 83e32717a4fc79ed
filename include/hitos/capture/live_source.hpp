// SPDX-License-Identifier: GPL-3.0-or-later
// A tour that comes in while it is mapped.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/base/message.hpp"
#include "hitos/capture/file_growth.hpp"
#include "hitos/capture/log_format.hpp"
#include "hitos/capture/tour_reader.hpp"

namespace hitos {

/// Whether it is the address of a server ("ws://…", or "HOST:PORT" where no file has that name),
/// not the name of a file.
bool is_websocket_address(std::string_view source);

/// How it stands with the connection to a server.
struct LinkState {
    bool connected = true;
    bool given_up = false;          ///< it was lost, and looked for in vain: the tour is over
    std::uint64_t losses = 0;       ///< how often it was lost
    std::uint64_t passed_over = 0;  ///< messages that are too large, or not of the protocol
};

class FoxgloveReceiver;
class ReceivedFile;

/// Whatever a tour comes by, it is a file first, so that nothing is lost and the same file gives
/// the same map again: one that another program writes, or one that what comes in is put into. Any
/// reader that is told its growth() reads on as long as it comes.
class LiveSource {
  public:
    /// Whether one that is being waited for is to go on.
    using GoesOn = std::function<bool()>;
    /// Where nobody says otherwise: how many scans are looked at before the first one is taken, and
    /// for how long a lost connection is looked for.
    static constexpr std::size_t kOpeningScans = 20;
    static constexpr std::chrono::seconds kPatience{60};
    /// Who waits for less is not told so [s].
    static constexpr double kWorthSaying = 1.0;

    /// Follows a file that another program writes. Throws FileError where it cannot.
    explicit LiveSource(const std::filesystem::path& file);
    /// Keeps all that comes through the descriptor, which is not closed, in a new file: `name` with
    /// the ending .mcap where that is what comes, else .log. It is over where the other end closes.
    /// Waits for the first byte. Null where that never comes. Throws FileError where the file is
    /// there already, unless it is to be replaced, or cannot be written.
    static std::unique_ptr<LiveSource> of_pipe(int descriptor, const std::filesystem::path& name,
                                               bool replace, const GoesOn& goes_on);
    /// Keeps what a server of the Foxglove WebSocket protocol ("ws://HOST:PORT") tells of lasers,
    /// odometry and transforms in a new file, `name` with the ending .mcap. A connection that is
    /// lost is looked for again for as long as `patience` goes; then the tour is over. Throws
    /// ConfigError where the address is none, FileError where nobody answers there, somebody who
    /// does not speak the protocol, or the file is there already or cannot be written. Null where
    /// it was not to go on before it was connected.
    static std::unique_ptr<LiveSource> of_server(const std::string& url,
                                                 const std::filesystem::path& name, bool replace,
                                                 std::chrono::seconds patience,
                                                 const GoesOn& goes_on);
    ~LiveSource();
    LiveSource(const LiveSource&) = delete;
    LiveSource& operator=(const LiveSource&) = delete;

    const std::filesystem::path& file() const { return file_; }
    const std::shared_ptr<FileGrowth>& growth() const { return growth_; }

    /// What has come when the first scan is about to be taken.
    struct Opening {
        std::uint64_t bytes = 0;
        std::size_t scans = 0;
        std::size_t readings = 0;
        Message problem = {};    ///< why nothing can be made of it yet; empty where something can
        bool to_choose = false;  ///< it has several lasers or odometries, and nobody said which
    };
    /// Waits for so many scans, by which is decided what has to be before the first one, or for the
    /// end of what comes. `told` hears how far that is, at least ten times a second; where it says
    /// false, nothing is given. Throws what open_log() throws of what will not get better by
    /// waiting, or is over.
    std::optional<Opening> wait_for_opening(std::string_view format, const ReadOptions& options,
                                            std::size_t scans,
                                            const std::function<bool(const Opening&)>& told);

    /// Whether anything has come that is worth to be kept.
    bool holds_something() const;
    /// Where it has not the file goes again, and one that it was to replace is back, which is told.
    /// So it is at the end where nobody asks for it.
    bool give_back();
    /// The one that it was to replace, which stands beside it until replace_former() says that what
    /// came is worth more; empty where there is none.
    std::filesystem::path former() const;
    void replace_former();
    /// No more is waited for: the tour is what has come by now.
    void end();
    /// What a server offers, with how many messages have come; nothing where none is asked.
    std::vector<RecordedTopic> topics() const;
    LinkState link() const;
    /// What has happened to a connection since this was last asked, in words.
    std::vector<Message> take_news();
    /// Why it was over before its time, or why something is missing; nothing where all is well.
    std::optional<FileError> problem() const;

  private:
    /// Puts what comes into the file until it is over or no more is wanted; throws FileError.
    using Receive = std::function<void(const std::stop_token& stop, LiveSource& source)>;
    LiveSource(std::unique_ptr<ReceivedFile> received, Receive receive);
    Opening opening_now(std::string_view format, ReadOptions options, std::size_t scans) const;

    std::filesystem::path file_;
    std::shared_ptr<FileGrowth> growth_;
    std::shared_ptr<const FoxgloveReceiver> server_;  ///< null where none is asked
    std::unique_ptr<ReceivedFile> received_;          ///< null where another program writes it
    std::mutex ending_;
    mutable std::mutex mutex_;
    std::optional<FileError> problem_;
    std::vector<Message> news_;
    std::jthread receiver_;  // last: it uses everything above
};

}  // namespace hitos
