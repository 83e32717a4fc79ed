// SPDX-License-Identifier: GPL-3.0-or-later
// What a program does to names and bytes, noted for tests of power loss: HITOS_FAULT_JOURNAL names
// a folder in which files stay that lose their last name, under the numbers of their inodes.
#pragma once

#include <mutex>
#include <string_view>

namespace hitos::faults {

bool keeps_journal();
void renew_journal();

/// Holds others off while one change is done and noted, so that the journal has their order.
class Change {
  public:
    Change();
    Change(const Change&) = delete;
    Change& operator=(const Change&) = delete;

    /// Keeps the file that is about to lose this name, if there is one.
    void keep(int folder, const char* path);
    /// A line "did N WHAT INODE\tPATH\tOTHER" in the report; paths are whole ones.
    void tell(const char* what, int folder, const char* path, int other_folder = 0,
              const char* other = nullptr);
    /// The same of an open file.
    void tell(const char* what, int descriptor);

  private:
    std::unique_lock<std::mutex> turn_;
};

}  // namespace hitos::faults
