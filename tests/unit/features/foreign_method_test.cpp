// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "extractors.hpp"
#include "hitos/base/error.hpp"
#include "hitos/features/line_methods.hpp"
#include "wall_scan.hpp"

namespace hitos {
namespace {

/// What somebody's own method might return of any scan: these lines, with three points.
DetectedLine g_returned;

class Foreign final : public MetodoExtraccionRectas {
  public:
    void extract_lines(const Scan& /*scan*/, Observation& out) override {
        out.support = {{1.0, 0.0}, {1.0, 1.0}, {1.0, 2.0}};
        out.lines = {g_returned};
    }
};

/// Before anything looks into the registry.
const bool kAdded = [] {
    LineMethodEntry entry;
    entry.word = "foreign";
    entry.label = "Foreign";
    entry.purpose = "for tests";
    entry.make = [](const ExtractionParams&, std::uint64_t) { return std::make_unique<Foreign>(); };
    line_methods().add(std::move(entry));
    return true;
}();

std::string told_of(const DetectedLine& returned) {
    g_returned = returned;
    ExtractionParams params;
    params.method = "foreign";
    try {
        extract(params, {});
        return "";
    } catch (const Error& error) {
        return error.what();
    }
}

TEST(ForeignMethod, WhatCannotBeIsRefusedBeforeAnybodyUsesIt) {
    ASSERT_TRUE(kAdded);
    const Recta line{1.0, 0.0};
    EXPECT_EQ(told_of({line, 0, 3}), "");
    EXPECT_EQ(told_of({line, 2, 1}), "");
    for (const auto& [first, count] : {std::pair{0U, 0U},
                                       {3U, 1U},
                                       {1U, 3U},
                                       {4U, 0U},
                                       {1U, std::numeric_limits<std::uint32_t>::max()}}) {
        EXPECT_NE(told_of({line, first, count}).find("points from"), std::string::npos)
            << first << ", " << count;
    }
    EXPECT_NE(told_of({{std::numeric_limits<double>::quiet_NaN(), 0.0}, 0, 3}).find("finite"),
              std::string::npos);
}

}  // namespace
}  // namespace hitos
