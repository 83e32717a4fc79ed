// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/drawing/picture_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "hitos/base/error.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using test::message_of;
using test::TempFolder;
using ::testing::HasSubstr;

/// 12 x 10 m with a cell of 0.5 m: free but for a wall at the right end of the bottom row.
Grid grid_map() {
    GridParams params;
    params.resolution_m = 0.5;
    Grid grid(params);
    Scan scan;
    for (int row = 0; row < 20; ++row) {
        scan.points = {{11.5, 0.0}};
        grid.add(scan, {0.25, 0.25 + 0.5 * row, 0.0});
    }
    return grid;
}

cv::Mat decoded(const std::string& bytes) {
    const std::vector<std::uint8_t> buffer(bytes.begin(), bytes.end());
    return cv::imdecode(buffer, cv::IMREAD_UNCHANGED);
}

cv::Vec3b pixel_at(const cv::Mat& image, int x, int y) {
    return image.at<cv::Vec3b>(y, x);
}

bool is_red(const cv::Vec3b& p) {
    return p[2] > 200 && p[1] < 60 && p[0] < 60;
}
bool is_green(const cv::Vec3b& p) {
    return p[1] > 120 && p[2] < 60 && p[0] < 60;
}
bool is_blue(const cv::Vec3b& p) {
    return p[0] > 200 && p[2] < 60;
}

TEST(EncodePicture, PngHoldsThePictureExactly) {
    const Grid::Picture picture{3, 2, {0, 50, 100, 150, 205, 255}};
    const cv::Mat image = decoded(encode_picture(picture, "png"));
    ASSERT_EQ(image.size(), cv::Size(3, 2));
    ASSERT_EQ(image.type(), CV_8UC1);
    EXPECT_THAT(std::vector<std::uint8_t>(image.begin<std::uint8_t>(), image.end<std::uint8_t>()),
                ::testing::ElementsAreArray(picture.grey));
}

TEST(EncodePicture, JpgIsNearThePicture) {
    const Grid grid = grid_map();
    const Grid::Picture picture = grid.picture();
    const std::string bytes = encode_picture(grid, {}, "JPG");
    EXPECT_TRUE(bytes.starts_with("\xff\xd8\xff"));
    const cv::Mat image = decoded(bytes);
    ASSERT_EQ(image.size(), cv::Size(picture.width, picture.height));
    for (int y = 0; y < image.rows; ++y) {
        for (int x = 0; x < image.cols; ++x) {
            EXPECT_NEAR(image.at<std::uint8_t>(y, x),
                        picture.grey[static_cast<std::size_t>(y * picture.width + x)], 25);
        }
    }
}

TEST(EncodePicture, ScaleRepeatsCells) {
    const Grid grid = grid_map();
    const Grid::Picture picture = grid.picture();
    const cv::Mat image = decoded(encode_picture(grid, {.scale = 3, .paths = {}}, "png"));
    ASSERT_EQ(image.size(), cv::Size(3 * picture.width, 3 * picture.height));
    ASSERT_EQ(image.channels(), 1);
    for (int y = 0; y < image.rows; ++y) {
        for (int x = 0; x < image.cols; ++x) {
            ASSERT_EQ(image.at<std::uint8_t>(y, x),
                      picture.grey[static_cast<std::size_t>(y / 3 * picture.width + x / 3)]);
        }
    }
}

TEST(EncodePicture, DrawsThePathWhereItWas) {
    const Grid grid = grid_map();
    PictureStyle style{.scale = 10, .paths = {{{2.25, 2.25}, {8.25, 2.25}, {8.25, 8.25}}}};
    const cv::Mat image = decoded(encode_picture(grid, style, "png"));
    ASSERT_EQ(image.channels(), 3);
    ASSERT_EQ(image.size(), cv::Size(240, 200));
    // 20 pixels a metre, y upwards.
    EXPECT_TRUE(is_green(pixel_at(image, 45, 155)));
    EXPECT_TRUE(is_blue(pixel_at(image, 165, 35)));
    EXPECT_TRUE(is_red(pixel_at(image, 105, 155)));
    EXPECT_TRUE(is_red(pixel_at(image, 165, 95)));
    EXPECT_EQ(pixel_at(image, 105, 95)[0],
              pixel_at(image, 105, 95)[2]);  // off the path it stays grey
    EXPECT_EQ(pixel_at(image, 105, 145)[0], pixel_at(image, 105, 145)[2]);

    // In two tours: from the first one's end no way leads to the second's begin.
    style.paths = {{{2.25, 2.25}, {4.25, 2.25}}, {{8.25, 2.25}, {8.25, 8.25}}};
    const cv::Mat tours = decoded(encode_picture(grid, style, "png"));
    EXPECT_TRUE(is_green(pixel_at(tours, 45, 155)) && is_blue(pixel_at(tours, 165, 35)));
    EXPECT_TRUE(is_red(pixel_at(tours, 70, 155)) && is_red(pixel_at(tours, 165, 95)));
    EXPECT_FALSE(is_red(pixel_at(tours, 125, 155)));
}

TEST(EncodePicture, PassesOverPathPointsThatCannotBeDrawn) {
    const Grid grid = grid_map();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const PictureStyle style{
        .scale = 10,
        .paths = {{{2.25, 2.25}, {nan, 1.0}, {1e300, 1.0}, {-1e9, 0.0}, {8.25, 2.25}}}};
    const cv::Mat image = decoded(encode_picture(grid, style, "png"));
    EXPECT_TRUE(is_green(pixel_at(image, 45, 155)));
    EXPECT_TRUE(is_blue(pixel_at(image, 165, 155)));
    EXPECT_FALSE(is_red(pixel_at(image, 105, 155)));
    const PictureStyle lost{.paths = {{{nan, nan}}}};
    EXPECT_NO_THROW(encode_picture(grid, lost, "png"));
}

TEST(EncodePicture, ScaleBarHasARoundLength) {
    const Grid grid = grid_map();
    const cv::Mat image =
        decoded(encode_picture(grid, {.scale = 10, .paths = {}, .scale_bar = true}, "png"));
    ASSERT_EQ(image.channels(), 1);
    // A quarter of 12 m is 3 m: the bar is 2 m, 40 pixels.
    const int row = image.rows - 12;
    int black = 0;
    for (int x = 0; x < image.cols; ++x) black += image.at<std::uint8_t>(row, x) == 0 ? 1 : 0;
    EXPECT_EQ(black, 40);
    EXPECT_EQ(image.at<std::uint8_t>(row, 10), 0);
    EXPECT_EQ(image.at<std::uint8_t>(row, 49), 0);
    EXPECT_EQ(image.at<std::uint8_t>(row, 51), 255);
    // Too small a picture stays without.
    EXPECT_EQ(encode_picture(grid, {.scale = 1, .paths = {}, .scale_bar = true}, "png"),
              encode_picture(grid, {}, "png"));
}

TEST(EncodePicture, RefusesWhatItCannotDraw) {
    const Grid grid = grid_map();
    EXPECT_EQ(message_of<ConfigError>([&] { encode_picture(grid, {}, "bmp"); }),
              "kind: \"bmp\" is no kind of picture; allowed: one of png, jpg, jpeg");
    for (const int scale : {0, -1, 65}) {
        EXPECT_EQ(
            message_of<ConfigError>(
                [&] { encode_picture(grid, {.scale = scale, .paths = {}}, "png"); }),
            "scale: " + std::to_string(scale) + " is out of range; allowed: integers from 1 to 64");
    }
    EXPECT_THAT(message_of<Error>([&] { encode_picture(Grid{}, {}, "png"); }),
                HasSubstr("the grid map is empty"));
    const Grid::Picture wide{70000, 1, std::vector<std::uint8_t>(70000, 205)};
    EXPECT_THAT(message_of<Error>([&] { encode_picture(wide, "jpg"); }),
                HasSubstr("at most 65500 pixels a side and the picture has 70000 x 1; write PNG"));
    EXPECT_NO_THROW(encode_picture(wide, "png"));
}

TEST(EncodePicture, RefusesPicturesOfTooManyPixels) {
    GridParams params;
    params.resolution_m = 1.0;
    Grid grid(params);
    Scan scan;
    scan.points = {{700.0, 700.0}};
    grid.add(scan, {});
    EXPECT_EQ(
        message_of<Error>([&] { encode_picture(grid, {.scale = 64, .paths = {}}, "png"); }),
        "a picture of 44864 x 44864 pixels is too great; use a smaller scale or coarser cells");
}

TEST(WritePicture, WritesTheKindThatTheExtensionNames) {
    const TempFolder folder;
    const Grid grid = grid_map();
    const PictureStyle style{.scale = 2, .paths = {{{1.0, 1.0}, {5.0, 5.0}}}};
    for (const char* name : {"a.png", "b.PNG"}) {
        write_picture(grid, style, folder / name);
        EXPECT_EQ(test::content(folder / name), encode_picture(grid, style, "png"));
    }
    for (const char* name : {"a.jpg", "b.Jpeg"}) {
        write_picture(grid.picture(), folder / name);
        EXPECT_EQ(test::content(folder / name), encode_picture(grid.picture(), "jpg"));
    }
    EXPECT_EQ(folder.files(), 4U);
}

TEST(WritePicture, ErrorsNameTheFileAndLeaveWhatWasThere) {
    const TempFolder folder;
    const Grid grid = grid_map();
    const auto bmp = folder / "a.bmp";
    EXPECT_EQ(message_of<FileError>([&] { write_picture(grid, {}, bmp); }),
              bmp.string() +
                  ": found the extension \".bmp\"; pictures are written as .png, .jpg or .jpeg");
    EXPECT_THAT(message_of<FileError>([&] { write_picture(grid, {}, folder / "a"); }),
                HasSubstr("found the extension \"\""));
    const auto old = folder.put("old.png", "precious");
    EXPECT_THAT(message_of<FileError>([&] { write_picture(Grid{}, {}, old); }),
                HasSubstr(old.string() + ": the grid map is empty"));
    EXPECT_THAT(message_of<FileError>([&] { write_picture(grid, {.scale = 0, .paths = {}}, old); }),
                HasSubstr(old.string() + ": scale: 0 is out of range"));
    EXPECT_THAT(message_of<FileError>([&] { write_picture(grid, {}, old / "b.png"); }),
                HasSubstr((old / "b.png").string()));
    EXPECT_EQ(test::content(old), "precious");
    EXPECT_EQ(folder.files(), 1U);
}

TEST(PictureFile, ShrunkPicturesKeepThinWallsAndTheirPlace) {
    // 5 x 4 pixels from the top: a wall in the second column, unknown in the last one.
    MapImage image;
    image.origin = {2.0, -1.0};
    image.m_per_pixel = 0.5;
    image.picture = {5, 4, {}};
    for (int row = 0; row < 4; ++row) {
        for (const std::uint8_t grey : {std::uint8_t{255}, std::uint8_t{0}, std::uint8_t{255},
                                        std::uint8_t{201}, kUnknownGrey})
            image.picture.grey.push_back(grey);
    }
    const MapImage same = shrunk(image, 5);
    EXPECT_EQ(same.picture.grey, image.picture.grey);
    const MapImage small = shrunk(image, 3);
    EXPECT_EQ(small.m_per_pixel, 1.0);
    EXPECT_EQ(small.origin.x, 2.0);
    EXPECT_EQ(small.origin.y, -1.0);
    EXPECT_EQ(small.picture.width, 3);
    EXPECT_EQ(small.picture.height, 2);
    EXPECT_EQ(small.picture.grey,
              (std::vector<std::uint8_t>{0, 228, kUnknownGrey, 0, 228, kUnknownGrey}));
    // An odd row is left over at the top, away from the origin.
    image.picture.height = 3;
    image.picture.grey.resize(15);
    std::fill_n(image.picture.grey.begin(), 5, std::uint8_t{255});
    const MapImage odd = shrunk(image, 3);
    EXPECT_EQ(odd.picture.grey, (std::vector<std::uint8_t>{255, 255, 255, 0, 228, kUnknownGrey}));
}

TEST(PictureFile, WhatNoJpgCouldHoldIsDrawnCoarser) {
    MapImage image;
    image.picture = {70000, 2, std::vector<std::uint8_t>(140000, 255)};
    image.picture.grey[69999] = 0;
    EXPECT_EQ(fitted(image, "png").picture.width, 70000);
    const MapImage coarse = fitted(image, "jpg");
    EXPECT_EQ(coarse.picture.width, 35000);
    EXPECT_EQ(coarse.picture.height, 1);
    EXPECT_EQ(coarse.picture.grey.back(), 0) << "a thin wall stays";
    EXPECT_EQ(coarse.m_per_pixel, 2 * image.m_per_pixel);
    const TempFolder folder;
    write_picture(coarse, {}, folder / "map.jpg");
    EXPECT_EQ(read_grey_picture(folder / "map.jpg").width, 35000);
    // Nor any file that is to be written in seconds.
    image.picture = {12000, 12000, std::vector<std::uint8_t>(144'000'000, 255)};
    EXPECT_EQ(fitted(std::move(image), "png").picture.width, 6000);
}

TEST(PictureFile, GreyPicturesAreReadBackAsTheyWere) {
    const TempFolder folder;
    const Grid::Picture picture = grid_map().picture();
    write_picture(picture, folder / "map.png");
    const Grid::Picture read = read_grey_picture(folder / "map.png");
    EXPECT_EQ(read.width, picture.width);
    EXPECT_EQ(read.height, picture.height);
    EXPECT_EQ(read.grey, picture.grey);
    EXPECT_THAT(message_of<FileError>([&] { read_grey_picture(folder / "none.png"); }),
                HasSubstr("none.png"));
    folder.put("text.png", "no picture");
    EXPECT_THAT(message_of<FormatError>([&] { read_grey_picture(folder / "text.png"); }),
                HasSubstr("is no picture, or a damaged one; expected PNG, JPG, PGM or BMP"));
}

TEST(PictureFile, DamagedMapsAreToldInOurWordsAlone) {
    const TempFolder folder;
    folder.put("cut.pgm", "P5\n100 100\n255\nabc");
    ::testing::internal::CaptureStderr();
    EXPECT_THROW(read_grey_picture(folder / "cut.pgm"), FormatError);
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
    EXPECT_TRUE(std::cerr.good());
    folder.put("letters.pgm", "P2\n3 2\n255\n0 100 200\n255 10 20");
    EXPECT_EQ(read_grey_picture(folder / "letters.pgm").grey,
              (std::vector<std::uint8_t>{0, 100, 200, 255, 10, 20}));
}

/// A PNG's head with a good checksum, of so many pixels.
std::string png_head(std::uint32_t width, std::uint32_t height) {
    std::string text("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16);
    for (const std::uint32_t value : {width, height}) {
        for (int shift = 24; shift >= 0; shift -= 8)
            text += static_cast<char>(value >> static_cast<unsigned>(shift));
    }
    return text + std::string("\x08\0\0\0\0\0\0\0\0", 9);
}

TEST(PictureFile, PixelsAreCountedBeforeThereIsRoomForThem) {
    const TempFolder folder;
    const auto refusal = [&](const std::string& name, const std::string& bytes) {
        folder.put(name, bytes);
        return message_of<FormatError>([&] { read_mean_picture(folder / name); });
    };
    EXPECT_THAT(refusal("a.png", png_head(31000, 31000)),
                HasSubstr("a.png: has 31000 x 31000 pixels; expected at most 100000000"));
    EXPECT_THAT(refusal("a.pgm", "P5\n# c\n40000 # d\n30000\n255\n"),
                HasSubstr("40000 x 30000 pixels"));
    EXPECT_THAT(refusal("b.pgm", "P5 99999999999999999999 3 255\n"), HasSubstr(" x 3 pixels"));
    std::string bmp("BM" + std::string(12, '\0') + "(" + std::string(3, '\0'));
    bmp += std::string("\0\0\1\0\0\0\1\0", 8) + std::string(40, '\0');
    EXPECT_THAT(refusal("a.bmp", bmp), HasSubstr("65536 x 65536 pixels"));
    const std::string frame(
        "\xff\xd8\xff\xc0\0\x0b\x08\xea\x60\xea\x60\1\1\x11\0"
        "\xff\xda\0\x08\1\1\0\0\x3f\0\xff\xd9",
        27);
    EXPECT_THAT(refusal("a.jpg", frame), HasSubstr("60000 x 60000 pixels"));
    std::string of_no_height = frame;
    of_no_height.replace(7, 2, std::string(2, '\0'));
    EXPECT_THAT(refusal("b.jpg", of_no_height), HasSubstr("is no picture"));
    // No other kind of picture goes to a library at all, whatever its name.
    EXPECT_THAT(refusal("a.png", "<VRTDataset rasterXSize=\"1\" rasterYSize=\"1\"/>"),
                HasSubstr("expected PNG, JPG, PGM or BMP"));
}

TEST(PictureFile, HalfAPictureOrADamagedOneIsNone) {
    const TempFolder folder;
    for (const std::string kind : {"png", "jpg"}) {
        const std::string whole = encode_picture(grid_map().picture(), kind);
        const auto read = [&](const std::string& bytes) {
            folder.put("map." + kind, bytes);
            read_mean_picture(folder / ("map." + kind));
        };
        EXPECT_NO_THROW(read(whole));
        ::testing::internal::CaptureStderr();
        for (const std::size_t part : {2U, 3U, 10U}) {
            EXPECT_THROW(read(whole.substr(0, whole.size() - whole.size() / part)), FormatError)
                << kind << part;
        }
        std::string damaged = whole;
        // Behind a JPG's tables, where no byte like that may follow itself.
        for (std::size_t i = whole.size() - 60; i < whole.size() - 20; ++i) damaged[i] = '\xff';
        EXPECT_THROW(read(damaged), FormatError) << kind;
        EXPECT_EQ(::testing::internal::GetCapturedStderr(), "") << "in our words alone";
    }
}

TEST(PictureFile, EndsOfThePathCanBeMarkedByCrossAndRing) {
    PictureStyle style;
    style.scale = 4;
    style.paths = {{{2.0, 2.0}, {8.0, 6.0}}};
    style.marks = PathMarks::cross_and_ring;
    const cv::Mat image = decoded(encode_picture(grid_map(), style, "png"));
    const auto pixel = [&](double x, double y) {
        return pixel_at(image, static_cast<int>(x * 8.0),
                        image.rows - 1 - static_cast<int>(y * 8.0));
    };
    EXPECT_EQ(pixel(2.0, 2.0), cv::Vec3b(0, 160, 0)) << "the arms of the cross meet there";
    const cv::Vec3b inside = pixel(8.0, 6.5);
    EXPECT_NEAR(inside[0], inside[2], 40) << "grey, for a ring is no blue disc";
}

/// As OpenCV reads it: the mean of the colours.
std::vector<std::uint8_t> means_by_opencv(const std::string& bytes) {
    const std::vector<std::uint8_t> buffer(bytes.begin(), bytes.end());
    const cv::Mat_<cv::Vec3b> image = cv::imdecode(buffer, cv::IMREAD_COLOR);
    std::vector<std::uint8_t> means;
    for (const cv::Vec3b& pixel : image)
        means.push_back(static_cast<std::uint8_t>((pixel[0] + pixel[1] + pixel[2] + 1) / 3));
    return means;
}

TEST(PictureFile, EveryKindIsReadAsAnotherLibraryReadsIt) {
    const TempFolder folder;
    cv::Mat colours(11, 13, CV_8UC3);
    cv::randu(colours, cv::Scalar::all(0), cv::Scalar::all(256));
    cv::GaussianBlur(colours, colours, cv::Size(5, 5), 2.0);
    cv::Mat grey;
    cv::cvtColor(colours, grey, cv::COLOR_BGR2GRAY);
    for (const cv::Mat& image : {colours, grey}) {
        for (const char* kind : {".png", ".jpg", ".bmp", ".ppm", ".pgm"}) {
            if (std::string_view(kind) == (image.channels() > 1 ? ".pgm" : ".ppm")) continue;
            std::vector<std::uint8_t> written;
            ASSERT_TRUE(cv::imencode(kind, image, written)) << kind;
            const std::string bytes(written.begin(), written.end());
            folder.put("picture", bytes);
            const MeanPicture read = read_mean_picture(folder / "picture");
            EXPECT_EQ(read.grey.width, 13) << kind;
            EXPECT_EQ(read.grey.height, 11) << kind;
            EXPECT_EQ(read.grey.grey, means_by_opencv(bytes)) << kind << image.channels();
            EXPECT_TRUE(read.alpha.empty()) << kind;
        }
    }
}

TEST(PictureFile, OfSixteenBitsTheUpperOnesAreTaken) {
    const TempFolder folder;
    cv::Mat image(1, 3, CV_16UC1);
    image.at<std::uint16_t>(0, 0) = 0;
    image.at<std::uint16_t>(0, 1) = 130 * 257;
    image.at<std::uint16_t>(0, 2) = 65535;
    for (const char* kind : {".png", ".pgm"}) {
        std::vector<std::uint8_t> written;
        ASSERT_TRUE(cv::imencode(kind, image, written));
        folder.put("picture", std::string(written.begin(), written.end()));
        EXPECT_EQ(read_grey_picture(folder / "picture").grey,
                  (std::vector<std::uint8_t>{0, 130, 255}))
            << kind;
    }
}

TEST(PictureFile, TransparentPixelsAreToldApart) {
    const TempFolder folder;
    cv::Mat image(1, 2, CV_8UC4, cv::Scalar(10, 20, 30, 255));
    image.at<cv::Vec4b>(0, 1) = cv::Vec4b(30, 30, 30, 0);
    std::vector<std::uint8_t> written;
    ASSERT_TRUE(cv::imencode(".png", image, written));
    folder.put("picture.png", std::string(written.begin(), written.end()));
    const MeanPicture read = read_mean_picture(folder / "picture.png");
    EXPECT_EQ(read.grey.grey, (std::vector<std::uint8_t>{20, 30}));
    EXPECT_EQ(read.alpha, (std::vector<std::uint8_t>{255, 0}));
}

TEST(PictureFile, BitsAndSmallGreysOfNetpbmAreSpread) {
    const TempFolder folder;
    const auto greys = [&](const std::string& bytes) {
        folder.put("picture", bytes);
        return read_grey_picture(folder / "picture").grey;
    };
    const std::vector<std::uint8_t> bits{0, 255, 0, 255, 255, 255};
    EXPECT_EQ(greys("P1\n# walls\n3 2\n1 0 1\n000"), bits);
    EXPECT_EQ(greys("P1 3 2 101000"), bits);
    EXPECT_EQ(greys("P4 3 2\n\xbf\x1f"), bits) << "of each row's last byte five bits are nothing";
    EXPECT_EQ(greys("P2 3 1 15 0 7 15"), (std::vector<std::uint8_t>{0, 119, 255}));
    EXPECT_EQ(greys("P3 1 1 255 10 20 30"), (std::vector<std::uint8_t>{20}));
    for (const char* broken :
         {"P4 9 2\nabc", "P1 3 2 10100", "P2 1 1 0 0", "P5 2 1 255\na", "P5 2"}) {
        folder.put("picture", broken);
        EXPECT_THROW(read_grey_picture(folder / "picture"), FormatError) << broken;
    }
}

/// A BMP of two colours, black and (10, 20, 30), whose rows are `raster`.
std::string bmp_of_bits(std::int32_t width, std::int32_t height, const std::string& raster,
                        char compression = 0) {
    const auto number = [](std::int64_t value) {
        std::string bytes;
        for (unsigned shift = 0; shift < 32; shift += 8)
            bytes += static_cast<char>(static_cast<std::uint64_t>(value) >> shift);
        return bytes;
    };
    constexpr int kRaster = 14 + 40 + 8;
    std::string text = "BM" + number(0) + number(0) + number(kRaster) + number(40);
    text += number(width) + number(height) + std::string("\1\0\1\0", 4);
    text += std::string(1, compression) + std::string(23, '\0');
    return text + std::string("\0\0\0\0\x1e\x14\x0a\0", 8) + raster;
}

TEST(PictureFile, BmpOfBitsStandsOnItsHeadOrNot) {
    const TempFolder folder;
    const std::string raster("\xa0\0\0\0\x40\0\0\0", 8);
    folder.put("up.bmp", bmp_of_bits(3, 2, raster));
    EXPECT_EQ(read_grey_picture(folder / "up.bmp").grey,
              (std::vector<std::uint8_t>{0, 20, 0, 20, 0, 20}));
    folder.put("down.bmp", bmp_of_bits(3, -2, raster));
    EXPECT_EQ(read_grey_picture(folder / "down.bmp").grey,
              (std::vector<std::uint8_t>{20, 0, 20, 0, 20, 0}));
    for (const std::string& broken :
         {bmp_of_bits(3, 2, raster, 1), bmp_of_bits(3, 3, raster), bmp_of_bits(40, 2, raster)}) {
        folder.put("broken.bmp", broken);
        EXPECT_THAT(message_of<FormatError>([&] { read_grey_picture(folder / "broken.bmp"); }),
                    HasSubstr("BMP that is not compressed"));
    }
}

}  // namespace
}  // namespace hitos
