// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/drawing/contact_sheet.hpp"

#include <gmock/gmock.h>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "hitos/base/error.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using test::message_of;
using test::TempFolder;
using ::testing::HasSubstr;

/// A free square of `side` metres round the origin, in a wall of one pixel.
MapImage sheet_room(double side, double m_per_pixel) {
    MapImage map;
    map.m_per_pixel = m_per_pixel;
    map.origin = {-side / 2.0, -side / 2.0};
    const int pixels = static_cast<int>(side / m_per_pixel);
    map.picture = {pixels, pixels,
                   std::vector<std::uint8_t>(
                       static_cast<std::size_t>(pixels) * static_cast<std::size_t>(pixels), 255)};
    for (int i = 0; i < pixels; ++i) {
        for (const int at : {i, (pixels - 1) * pixels + i, i * pixels, i * pixels + pixels - 1})
            map.picture.grey[static_cast<std::size_t>(at)] = 0;
    }
    return map;
}

ContactSheet sheet_of(int tiles, int columns) {
    ContactSheet sheet;
    sheet.title = "title";
    sheet.columns = columns;
    for (int i = 0; i < tiles; ++i) {
        sheet.tiles.push_back({{"value " + std::to_string(i), "second line"},
                               sheet_room(10.0, 0.05),
                               {{{-2.0, -2.0}, {2.0, -2.0}, {2.0, 2.0}}}});
    }
    return sheet;
}

cv::Mat drawn(const ContactSheet& sheet) {
    const std::string bytes = encode_contact_sheet(sheet, "png");
    const std::vector<std::uint8_t> buffer(bytes.begin(), bytes.end());
    return cv::imdecode(buffer, cv::IMREAD_COLOR);
}

int count(const cv::Mat& image, const cv::Vec3b& colour) {
    cv::Mat equal;
    cv::inRange(image, colour, colour, equal);
    return cv::countNonZero(equal);
}

int red_pixels(const cv::Mat& image) {
    int found = 0;
    for (int y = 0; y < image.rows; ++y) {
        for (int x = 0; x < image.cols; ++x) {
            const auto& pixel = image.at<cv::Vec3b>(y, x);
            if (pixel[2] > pixel[1] + 60 && pixel[2] > pixel[0] + 60) ++found;
        }
    }
    return found;
}

TEST(ContactSheet, LaysTilesInRowsWithTheirWordsBelow) {
    const cv::Mat one = drawn(sheet_of(1, 0));
    const cv::Mat six = drawn(sheet_of(6, 3));
    const cv::Mat column = drawn(sheet_of(6, 1));
    EXPECT_NEAR(six.cols, 3 * (300 + 10) + 10, 3);
    EXPECT_GT(column.rows, 2 * six.rows);
    EXPECT_GT(six.rows, one.rows + 300);
    // Every tile brings its path.
    EXPECT_GT(red_pixels(one), 200);
    EXPECT_NEAR(red_pixels(six), 6 * red_pixels(one), 6);
    ContactSheet silent = sheet_of(6, 3);
    for (SheetTile& tile : silent.tiles) tile.caption = {"", ""};
    const cv::Vec3b white(255, 255, 255);
    EXPECT_GT(count(drawn(silent), white), count(six, white) + 6 * 100) << "captions are drawn";
}

TEST(ContactSheet, ShowsAllMapsAtOneScaleWhateverTheirPixels) {
    ContactSheet sheet = sheet_of(2, 2);
    sheet.tiles[1].map = sheet_room(5.0, 0.025);  // half the room in as many pixels
    for (SheetTile& tile : sheet.tiles) tile.paths.clear();
    const cv::Mat image = drawn(sheet);
    // Free pixels between the walls along a row through the middle of both tiles.
    const int middle = 10 + 2 * 17 + 150;
    const auto free_from = [&](int x) {
        int found = 0;
        for (int i = 0; i < 300; ++i) {
            if (image.at<cv::Vec3b>(middle, x + i) == cv::Vec3b(255, 255, 255)) ++found;
        }
        return found;
    };
    EXPECT_NEAR(free_from(10), 300 - 4, 4);
    EXPECT_NEAR(free_from(10 + 300 + 10), 150 - 4, 4);
}

TEST(ContactSheet, AFewGiantMapsAreCutLestTheOthersVanish) {
    ContactSheet sheet = sheet_of(5, 5);
    sheet.tiles[3].map = sheet_room(1000.0, 2.0);
    for (SheetTile& tile : sheet.tiles) tile.paths.clear();
    const cv::Mat image = drawn(sheet);
    const int middle = 10 + 2 * 17 + 150;
    int found = 0;
    for (int x = 10; x < 310; ++x) {
        if (image.at<cv::Vec3b>(middle, x) == cv::Vec3b(255, 255, 255)) ++found;
    }
    EXPECT_GT(found, 150) << "the room of 10 m still fills most of its tile";
}

TEST(ContactSheet, TilesShrinkAndTooManyAreRefused) {
    ContactSheet sheet = sheet_of(1, 0);
    sheet.tiles.resize(600, sheet.tiles.front());
    const cv::Mat many = drawn(sheet);
    EXPECT_LE(std::int64_t{many.cols} * many.rows, kMostSheetPixels);
    sheet.tiles.resize(20000, sheet.tiles.front());
    EXPECT_THAT(message_of<Error>([&] { encode_contact_sheet(sheet, "png"); }),
                HasSubstr("20000 maps are too many for one sheet"));
}

TEST(ContactSheet, DrawsLettersOfAnyAlphabetAsTheyAre) {
    std::set<std::string> pictures;
    for (const char* title : {"n", "\xc3\xb1", "\xc3\xa9", "\xce\xa9", "\xd0\x96", "?"}) {
        ContactSheet sheet = sheet_of(1, 1);
        sheet.title = title;
        pictures.insert(encode_contact_sheet(sheet, "png"));
    }
    EXPECT_EQ(pictures.size(), 6U) << "is DejaVu Sans installed (Debian: fonts-dejavu-core)?";
    ContactSheet sheet = sheet_of(1, 1);
    sheet.title = "\xff title";  // the name of a file may be no text
    const cv::Mat before = drawn(sheet);
    sheet.title += "s";
    EXPECT_GT(cv::norm(before, drawn(sheet)), 0.0) << "what comes after it is drawn";
}

TEST(ContactSheet, IsTheSameOnWhateverThreadItIsDrawn) {
    ContactSheet sheet = sheet_of(2, 2);
    sheet.tiles[0].caption[0] = "\xce\xa9 \xe8\xb5\xb0\xe5\xbb\x8a";  // the latter of another font
    const std::string expected = encode_contact_sheet(sheet, "png");
    std::vector<std::string> others(4);
    {
        std::vector<std::jthread> threads;
        for (std::string& other : others) {
            threads.emplace_back([&] { other = encode_contact_sheet(sheet, "png"); });
        }
    }
    for (const std::string& other : others) EXPECT_TRUE(other == expected);
}

TEST(ContactSheet, SaysWhatItCannotDraw) {
    EXPECT_THAT(message_of<Error>([] { encode_contact_sheet({}, "png"); }), HasSubstr("no map"));
    ContactSheet failed;
    failed.tiles = {{{"p=5", "failed"}, {}, {}}};
    EXPECT_GT(drawn(failed).cols, 300);
    const TempFolder folder;
    EXPECT_THAT(message_of<FileError>([&] { write_contact_sheet(failed, folder / "sheet.bmp"); }),
                HasSubstr("sheet.bmp"));
    write_contact_sheet(failed, folder / "sheet.png");
    EXPECT_EQ(test::content(folder / "sheet.png").substr(1, 3), "PNG");
}

}  // namespace
}  // namespace hitos
