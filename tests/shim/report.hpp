// What the library of faults is told, and what it tells, by system calls that nobody has replaced.
#pragma once

#include <string_view>

namespace hitos::faults {

/// Which operations fail: HITOS_FAULT_FILE or HITOS_FAULT_MEMORY, `NUMBER:X[:WORD]`. NUMBER counts
/// from 1; 0 lets everything pass and lists it.
struct Order {
    bool given = false;
    long number = 0;
    long detail = 0;  ///< X: of files the errno, of memory the least bytes that count
    bool lasting = false;
    bool cut = false;  ///< "cut": a write does half its work first
};

Order order_from(const char* variable);

/// Whether main has begun: what comes before it belongs to the system.
bool in_main();

/// A line in the file HITOS_FAULT_REPORT. Takes no memory.
void report(std::string_view word, long number, std::string_view what, std::string_view detail);

/// The name of an open file, empty where it has none.
std::string_view name_of(int descriptor, char* room, std::size_t size);

}  // namespace hitos::faults
