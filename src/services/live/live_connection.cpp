// SPDX-License-Identifier: GPL-3.0-or-later
#include "live_connection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <cstdint>
#include <random>
#include <utility>

#include "live_mailbox.hpp"
#include "live_page.hpp"

namespace hitos::live {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using Code = boost::system::error_code;
using HttpRequest = http::request<http::empty_body>;
using HttpResponse = http::response<http::string_body>;

constexpr std::size_t kLongestRequest = 65536;
constexpr std::uint32_t kLongestHeader = 16 * 1024;
constexpr std::size_t kLongestTarget = 4096;
constexpr unsigned kVersion = 11;      // of HTTP, to who says none
constexpr std::size_t kChunk = 65536;  // in each of which a slow client shows that it reads

std::string_view view(beast::string_view text) {
    return {text.data(), text.size()};
}

/// Sends what waits in its mailbox, as fast as it is taken.
class WebSocketClient final : public Client, public std::enable_shared_from_this<WebSocketClient> {
  public:
    WebSocketClient(beast::tcp_stream&& stream, Stage& stage)
        : socket_(std::move(stream)),
          stall_(socket_.get_executor()),
          stage_(stage),
          mailbox_(stage) {}

    /// Takes the request for a WebSocket, whose protocol is one that we speak.
    void begin(HttpRequest request, const std::string& protocol) {
        beast::get_lowest_layer(socket_).expires_never();  // it has limits of its own
        websocket::stream_base::timeout limits{};
        limits.handshake_timeout = stage_.patience();
        limits.idle_timeout = 2 * stage_.patience();
        limits.keep_alive_pings = true;
        socket_.set_option(limits);
        socket_.set_option(
            websocket::stream_base::decorator([protocol](websocket::response_type& response) {
                response.set(http::field::sec_websocket_protocol, protocol);
            }));
        socket_.read_message_max(kLongestRequest);
        socket_.auto_fragment(false);  // it is done here
        const auto kept = std::make_shared<HttpRequest>(std::move(request));
        socket_.async_accept(*kept, [self = shared_from_this(), kept](Code error) {
            if (error) {
                self->leave();
                return;
            }
            self->mailbox_.put_text(self->stage_.server_info_text());
            self->mailbox_.put_text(self->stage_.advertisement_text());
            self->write_next();
            self->read_next();
        });
    }

    bool wants(std::size_t channel) const override { return mailbox_.wants(channel); }

    void offer(std::size_t channel, std::shared_ptr<const Payload> payload) override {
        mailbox_.offer(channel, std::move(payload));
        write_next();
    }

    void end() override {
        ending_ = true;
        write_next();
    }

  private:
    void read_next() {
        socket_.async_read(buffer_, [self = shared_from_this()](Code error, std::size_t) {
            if (error) {
                self->leave();
                return;
            }
            self->take();
            self->buffer_.consume(self->buffer_.size());
            if (!self->left_) self->read_next();
        });
    }

    void take() {
        const auto bytes = buffer_.cdata();
        if (socket_.got_text()) {
            mailbox_.take({static_cast<const char*>(bytes.data()), bytes.size()});
        } else {
            mailbox_.complain(
                "a binary message; expected text: nothing can be sent to this server");
        }
        if (mailbox_.hopeless()) {
            leave();
        } else {
            write_next();
        }
    }

    void write_next() {
        if (writing_ || left_ || !socket_.is_open()) return;
        if (const auto message = mailbox_.next()) {
            message_ = *message;
            body_ = message_.payload ? message_.payload->json : message_.text;
            at_ = 0;
            socket_.binary(message_.payload != nullptr);
            write_chunk();
        } else if (ending_ && !std::exchange(closing_, true)) {
            socket_.async_close({websocket::close_code::going_away, "the run is over"},
                                [self = shared_from_this()](Code) { self->leave(); });
        }
    }

    void write_chunk() {
        writing_ = true;
        const std::size_t part = std::min(kChunk, body_.size() - at_);
        const bool has_header = at_ == 0 && message_.payload != nullptr;
        const std::array<asio::const_buffer, 2> buffers{
            asio::buffer(message_.header.data(), has_header ? message_.header.size() : 0),
            asio::buffer(body_.data() + at_, part)};
        at_ += part;
        stall_.expires_after(stage_.patience());
        stall_.async_wait([self = shared_from_this()](Code error) {
            if (!error && self->writing_ &&
                self->stall_.expiry() <= asio::steady_timer::clock_type::now()) {
                self->leave();
            }
        });
        socket_.async_write_some(
            at_ == body_.size(), buffers,
            [self = shared_from_this()](Code error, std::size_t) { self->written(error); });
    }

    void written(Code error) {
        writing_ = false;
        stall_.cancel();
        if (error) {
            leave();
        } else if (at_ < body_.size()) {
            write_chunk();
        } else {
            message_ = {};
            write_next();
        }
    }

    /// Without a word: who is closed by us would not read it.
    void leave() {
        if (std::exchange(left_, true)) return;
        stall_.cancel();
        Code ignored;
        beast::get_lowest_layer(socket_).socket().close(ignored);
        stage_.leaves(shared_from_this());
    }

    websocket::stream<beast::tcp_stream> socket_;
    asio::steady_timer stall_;
    Stage& stage_;
    Mailbox mailbox_;
    beast::flat_buffer buffer_;  // what comes in
    Mailbox::Message message_;   // what is being written, its bytes, and how far
    std::string_view body_;
    std::size_t at_ = 0;
    bool writing_ = false;
    bool ending_ = false;
    bool closing_ = false;
    bool left_ = false;
};

/// Something that nobody guesses, for one page.
std::string nonce() {
    std::random_device random;
    return fmt::format("{:08x}{:08x}{:08x}{:08x}", random(), random(), random(), random());
}

std::string page_with(const std::string& nonce) {
    constexpr std::string_view kPlace = "NONCE";
    std::string page;
    page.reserve(kPage.size() + 2 * nonce.size());
    std::string_view rest = kPage;
    for (auto at = rest.find(kPlace); at != std::string_view::npos; at = rest.find(kPlace)) {
        page.append(rest.substr(0, at)).append(nonce);
        rest.remove_prefix(at + kPlace.size());
    }
    return page.append(rest);
}

HttpResponse response_of(http::status status, std::string text, unsigned version,
                         const std::string& policy = "default-src 'none'") {
    HttpResponse response{status, version};
    response.set(http::field::content_type, "text/plain; charset=utf-8");
    response.set(http::field::cache_control, "no-store");
    response.set("Content-Security-Policy",
                 policy + "; base-uri 'none'; form-action 'none'; frame-ancestors 'none'");
    response.set("X-Content-Type-Options", "nosniff");
    response.set("Referrer-Policy", "no-referrer");
    response.set("Cross-Origin-Resource-Policy", "same-origin");
    response.keep_alive(false);
    response.body() = std::move(text);
    return response;
}

HttpResponse busy(std::string text, unsigned version) {
    HttpResponse refusal = response_of(http::status::service_unavailable, std::move(text), version);
    refusal.set(http::field::retry_after, "10");
    return refusal;
}

/// The one of the protocols that the client offers which we speak; empty where there is none. The
/// first is the one that is specified; of the other our messages are the same.
std::string protocol_of(const HttpRequest& request) {
    http::token_list offered{request[http::field::sec_websocket_protocol]};
    for (const char* known : {"foxglove.websocket.v1", "foxglove.sdk.v1"}) {
        if (offered.exists(known)) return known;
    }
    return {};
}

/// What was asked for before it is known what it is.
class Visit final : public Visitor, public std::enable_shared_from_this<Visit> {
  public:
    Visit(asio::ip::tcp::socket&& socket, Stage& stage)
        : stream_(std::move(socket)), deadline_(stream_.get_executor()), stage_(stage) {
        parser_.header_limit(kLongestHeader);
        stage_.comes(*this);
    }
    ~Visit() override { stage_.goes(*this); }
    Visit(const Visit&) = delete;
    Visit& operator=(const Visit&) = delete;

    void begin() {
        constexpr int kShare = 4;  // of the patience that clients have
        deadline_.expires_after(stage_.patience() / kShare);
        deadline_.async_wait([self = shared_from_this()](Code error) {
            if (!error) self->refuse_late();
        });
        http::async_read_header(stream_, buffer_, parser_,
                                [self = shared_from_this()](Code error, std::size_t) {
                                    if (std::exchange(self->answered_, true)) return;
                                    self->deadline_.cancel();
                                    if (error) {
                                        self->refuse(error);
                                    } else {
                                        self->answer();
                                    }
                                });
    }

    bool idle() const override { return !answered_; }
    /// In one go, which a system's buffer takes.
    void give_way() override {
        deadline_.cancel();
        Code ignored;
        if (!std::exchange(answered_, true)) {
            HttpResponse response = busy("Too many have come; try again later.\n", kVersion);
            response.content_length(response.body().size());
            stream_.socket().non_blocking(true, ignored);
            http::write(stream_.socket(), response, ignored);
        }
        stream_.socket().close(ignored);
    }

  private:
    void answer() {
        const HttpRequest& request = parser_.get();
        const unsigned version = request.version();
        if (!stage_.answers_to(view(request[http::field::host]))) {
            send(response_of(http::status::forbidden,
                             "This server is for this machine alone, as localhost or 127.0.0.1.\n",
                             version));
            return;
        }
        const std::string_view target = view(request.target());
        if (target.size() > kLongestTarget) {
            send(response_of(http::status::uri_too_long, "There is one page here, /.\n", version));
        } else if (target.substr(0, target.find('?')) != "/") {
            send(response_of(http::status::not_found, "There is one page here, /.\n", version));
        } else if (websocket::is_upgrade(request)) {
            upgrade();
        } else if (request.method() == http::verb::get || request.method() == http::verb::head) {
            const std::string word = nonce();
            HttpResponse page = response_of(
                http::status::ok, page_with(word), version,
                fmt::format("default-src 'none'; script-src 'nonce-{0}'; style-src 'nonce-{0}'; "
                            "connect-src 'self'; img-src data:",
                            word));
            page.set(http::field::content_type, "text/html; charset=utf-8");
            send(std::move(page));
        } else {
            HttpResponse refusal = response_of(http::status::method_not_allowed,
                                               "There is nothing here but to look.\n", version);
            refusal.set(http::field::allow, "GET, HEAD");
            send(std::move(refusal));
        }
    }

    void upgrade() {
        const unsigned version = parser_.get().version();
        const std::string protocol = protocol_of(parser_.get());
        if (protocol.empty()) {
            send(response_of(http::status::bad_request,
                             "Expected the subprotocol foxglove.websocket.v1.\n", version));
        } else if (stage_.full()) {
            send(busy("As many look as may; try again later.\n", version));
        } else {
            const auto client = std::make_shared<WebSocketClient>(std::move(stream_), stage_);
            stage_.joins(client);
            client->begin(parser_.release(), protocol);
        }
    }

    /// What is no request, or half of one.
    void refuse(Code error) {
        if (error == http::error::end_of_stream) return;  // it has nothing to ask
        if (error == http::error::header_limit) {
            const auto bytes = buffer_.cdata();
            const std::string_view left(static_cast<const char*>(bytes.data()), bytes.size());
            const bool in_its_first_line =
                parser_.get().target().empty() && left.find('\n') == std::string_view::npos;
            send(in_its_first_line
                     ? response_of(http::status::uri_too_long, "There is one page here, /.\n",
                                   kVersion)
                     : response_of(http::status::request_header_fields_too_large,
                                   fmt::format("Expected headers of {} bytes at the most.\n",
                                               kLongestHeader),
                                   kVersion));
        } else if (error.category() == http::make_error_code(http::error::bad_method).category()) {
            send(response_of(http::status::bad_request, "Expected a request of HTTP/1.1.\n",
                             kVersion));
        }
    }

    void refuse_late() {
        if (std::exchange(answered_, true)) return;
        stream_.cancel();  // what is awaited
        send(response_of(http::status::request_timeout,
                         "Nothing was asked for in time; connect and ask again.\n", kVersion));
    }

    void send(HttpResponse response) {
        response.content_length(response.body().size());
        if (parser_.get().method() == http::verb::head) response.body().clear();
        response_ = std::move(response);
        stream_.expires_after(stage_.patience());
        http::async_write(stream_, response_, [self = shared_from_this()](Code, std::size_t) {
            Code ignored;
            self->stream_.socket().shutdown(asio::ip::tcp::socket::shutdown_send, ignored);
            self->stream_.expires_after(self->stage_.patience());
            self->take_rest();
        });
    }

    /// What is still sent to a socket that is closed would take the answer back.
    void take_rest() {
        stream_.async_read_some(asio::buffer(rest_),
                                [self = shared_from_this()](Code error, std::size_t) {
                                    if (!error) self->take_rest();
                                });
    }

    beast::tcp_stream stream_;
    asio::steady_timer deadline_;  // to have asked by
    Stage& stage_;
    bool answered_ = false;
    beast::flat_buffer buffer_;
    std::array<char, 4096> rest_{};
    http::request_parser<http::empty_body> parser_;
    HttpResponse response_;
};

}  // namespace

void begin_connection(asio::ip::tcp::socket socket, Stage& stage) {
    std::make_shared<Visit>(std::move(socket), stage)->begin();
}

}  // namespace hitos::live
