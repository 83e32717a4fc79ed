// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/capture/archivo.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "hitos/base/error.hpp"
#include "test_files.hpp"

namespace hitos {
namespace {

using test::TempDir;
using Kind = LineKind;

class ArchivoTest : public ::testing::Test {
  protected:
    TempDir folder_;
    std::filesystem::path path_ = folder_.put("some.log", "ODOM 1 0 0\n");
};

TEST_F(ArchivoTest, AFormatThatSaysNotHowItIsReadIsRefused) {
    LogFormat format = log_formats().find("player");
    format.word = "mine";
    EXPECT_NO_THROW(Archivo(path_, format));
    LogFormat silent = format;
    silent.classify = nullptr;
    EXPECT_THROW(Archivo(path_, silent), ConfigError);
    format.make_conversor = nullptr;
    EXPECT_THROW(Archivo(path_, format), ConfigError);
}

TEST_F(ArchivoTest, ClassifiesPlayerLines) {
    const LogFormat& player = log_formats().find("player");
    const std::string head = "1.0 16777343 6665 ";
    const auto kind = [&](const std::string& rest) { return player.classify(head + rest); };
    EXPECT_EQ(kind("laser 00 001 001 0000 -1 1"), Kind::scan);
    EXPECT_EQ(kind("laser 00 001 002 0"), Kind::scan);
    EXPECT_EQ(kind("laser 00 001 003 0"), Kind::scan);
    EXPECT_EQ(kind("laser 00 004 001 0 0 0"), Kind::scan);
    EXPECT_EQ(kind("laser 00 009 009 1"), Kind::other);
    EXPECT_EQ(kind("ranger 00 001 001 2 1 1"), Kind::scan);
    EXPECT_EQ(kind("ranger 00 001 003 2 1 1"), Kind::other);
    EXPECT_EQ(kind("ranger 00 004 005 0"), Kind::scan);
    EXPECT_EQ(kind("position2d 00 001 001 0"), Kind::odometry);
    EXPECT_EQ(kind("position2d 00 004 001 0"), Kind::other);
    EXPECT_EQ(kind("sonar 00 001 001 0"), Kind::other);
    EXPECT_EQ(kind("gripper 00 001 008 9"), Kind::other);
    EXPECT_EQ(kind("laser 00 001 002"), Kind::other);     // header only
    EXPECT_EQ(kind("laser 00 001 001"), Kind::scan);      // cut off
    EXPECT_EQ(kind("laser 00 0x1 001 1 2"), Kind::scan);  // for the converter to complain
    EXPECT_EQ(kind("laser 00"), Kind::damaged);
    EXPECT_EQ(player.classify("1.0 robot1 6665 laser 00 1.0 -1.5 1.5"), Kind::scan);
    EXPECT_EQ(player.classify("1.0 robot1 6665 position 00 1.0 0"), Kind::odometry);
    EXPECT_EQ(player.classify("1.0 robot1 6665 sync 00 1.0"), Kind::other);
    EXPECT_EQ(player.classify("garbage"), Kind::damaged);
    EXPECT_EQ(player.classify("1 2 3"), Kind::damaged);
}

TEST_F(ArchivoTest, ClassifiesTheOtherFormats) {
    const LogFormat& radish = log_formats().find("radish");
    EXPECT_EQ(radish.classify("laser 0 1"), Kind::scan);
    EXPECT_EQ(radish.classify("position 0 1"), Kind::odometry);
    EXPECT_EQ(radish.classify("sonar 0 1"), Kind::other);
    EXPECT_EQ(radish.classify("0.5 0.5"), Kind::damaged);
    const LogFormat& normalized = log_formats().find("normalized");
    EXPECT_EQ(normalized.classify("LASER 1 0"), Kind::scan);
    EXPECT_EQ(normalized.classify("ODOM 1 0 0"), Kind::odometry);
    EXPECT_EQ(normalized.classify("NOTE x"), Kind::other);
    EXPECT_EQ(normalized.classify("%"), Kind::damaged);
    const LogFormat& carmen = log_formats().find("carmen");
    EXPECT_EQ(carmen.classify("ODOM 1"), Kind::odometry);
    EXPECT_EQ(carmen.classify("FLASER 1"), Kind::both);
    EXPECT_EQ(carmen.classify("ROBOTLASER1 0"), Kind::both);
    EXPECT_EQ(carmen.classify("RAWLASER1 0"), Kind::scan);
    EXPECT_EQ(carmen.classify("RLASER 1"), Kind::other);
    EXPECT_EQ(carmen.classify("PARAM robot_front_laser_max 80"), Kind::scan);
    EXPECT_EQ(carmen.classify("PARAM robot_width 0.4"), Kind::other);
    EXPECT_EQ(carmen.classify("SYNC x"), Kind::other);
    EXPECT_EQ(carmen.classify("*"), Kind::damaged);
}

TEST_F(ArchivoTest, CursorsAreIndependent) {
    const auto path =
        folder_.put("both.log", "ODOM 1 0 0\nLASER 1 1 1 1\n\n# note\nODOM 2 0 0\nLASER 2 1 1 1\n");
    Archivo log(path, log_formats().find("normalized"));
    EXPECT_EQ(log.read_scan_line()->number, 2U);
    EXPECT_EQ(log.read_scan_line()->number, 6U);
    EXPECT_FALSE(log.read_scan_line());
    EXPECT_EQ(log.read_odometry_line()->number, 1U);
    const std::optional<RawLine> second = log.read_odometry_line();
    EXPECT_EQ(second->number, 5U);
    EXPECT_EQ(second->text, "ODOM 2 0 0");
    EXPECT_FALSE(second->shared);
    EXPECT_FALSE(log.read_odometry_line());
    EXPECT_EQ(log.progress(), 1.0);
    EXPECT_EQ(log.name(), path.string());
    const std::unique_ptr<Fuente> again = log.reopen();
    EXPECT_EQ(again->format().word, "normalized");
    EXPECT_EQ(again->read_scan_line()->number, 2U);
}

TEST_F(ArchivoTest, SharedLinesAreMarked) {
    Archivo log(folder_.put("c.log", "FLASER 1\nODOM 1\n"), log_formats().find("carmen"));
    EXPECT_TRUE(log.read_scan_line()->shared);
    EXPECT_TRUE(log.read_odometry_line()->shared);
    EXPECT_FALSE(log.read_odometry_line()->shared);
}

TEST_F(ArchivoTest, DamageIsToldOnceAndInBoundedMemory) {
    std::string text = "ODOM 1 0 0\n";
    for (int i = 0; i < 1000; ++i) text += "?\n";
    Archivo log(folder_.put("d.log", text), log_formats().find("normalized"));
    while (log.read_odometry_line()) {
    }
    EXPECT_FALSE(log.take_damage());
    EXPECT_FALSE(log.read_scan_line());
    int told = 0;
    while (const auto damage = log.take_damage()) {
        EXPECT_EQ(damage->first, static_cast<std::uint64_t>(std::min(told, 63) + 2));
        EXPECT_NE(damage->second.english().find("normalized"), std::string::npos);
        ++told;
    }
    EXPECT_EQ(told, 1000);
}

}  // namespace
}  // namespace hitos
