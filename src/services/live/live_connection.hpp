// SPDX-License-Identifier: GPL-3.0-or-later
// One who has connected: asks for the page, or stays as a client.
#pragma once

#include <boost/asio/ip/tcp.hpp>

#include "live_stage.hpp"

namespace hitos::live {

/// Reads what is asked for, and answers it. `stage` outlives it.
void begin_connection(boost::asio::ip::tcp::socket socket, Stage& stage);

}  // namespace hitos::live
