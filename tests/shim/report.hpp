// SPDX-License-Identifier: GPL-3.0-or-later
// What the library of faults is told, and what it tells, by system calls that nobody has replaced.
#pragma once

#include <string_view>
#include <vector>

namespace hitos::faults {

/// Which operations fail: HITOS_FAULT_FILE or HITOS_FAULT_MEMORY, `NUMBER:X[:WORD]`. NUMBER counts
/// from 1; 0 lets everything pass and lists it.
struct Order {
    bool given = false;
    long number = 0;
    long detail = 0;  ///< X: of files the errno, of memory the least bytes that count
    bool lasting = false;
    bool cut = false;  ///< "cut": a write does half its work first
    bool kill = false;
};

Order order_from(const char* variable);

/// Takes HITOS_FAULT_FILE, HITOS_FAULT_BELOW and HITOS_FAULT_JOURNAL as they are now, and counts
/// anew.
void renew_file_order();

/// Where HITOS_FAULT_SERVE is set: main runs in a child for each request on descriptor kRequests,
/// so that a program is loaded once however often it is run. Comes back in a child, with its
/// arguments, or with none where nothing is to be served.
std::vector<char*> served_arguments();

constexpr int kRequests = 198;
constexpr int kReplies = 199;

/// Whether main has begun: what comes before it belongs to the system.
bool in_main();

/// A line in the file HITOS_FAULT_REPORT. Takes no memory.
void report(std::string_view word, long number, std::string_view what, std::string_view detail);

/// The name of an open file, empty where it has none.
std::string_view name_of(int descriptor, char* room, std::size_t size);

}  // namespace hitos::faults
