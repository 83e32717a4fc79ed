// SPDX-License-Identifier: GPL-3.0-or-later
// Pages in two languages that say the same: the nine lessons, and the user's guide.
#include <gmock/gmock.h>

#include <sstream>

#include "hitos/workbench/shipped_data.hpp"
#include "support.hpp"

namespace hitos {
namespace {

/// What both languages of a page must have alike, in its order.
struct Page {
    std::vector<std::string> headings;  ///< their marks: "##"
    std::vector<std::string> code;      ///< without comments
    std::vector<std::string> links;     ///< where they and the pictures lead, from the English page
    std::size_t words = 0;
};

Page page_of(const std::filesystem::path& path) {
    Page page;
    std::istringstream text(test::content(path));
    bool fenced = false;
    for (std::string line; std::getline(text, line);) {
        if (line.starts_with("```")) {
            fenced = !fenced;
        } else if (fenced) {
            page.code.push_back(line.substr(0, line.find(" #")));
        } else if (line.starts_with("#")) {
            page.headings.push_back(line.substr(0, line.find(' ')));
        }
        for (std::size_t at = line.find("]("); !fenced && at != std::string::npos;
             at = line.find("](", at + 1)) {
            std::string link = line.substr(at + 2, line.find(')', at) - at - 2);
            if (link.starts_with("../")) link.erase(0, 3);
            page.links.push_back(link);
        }
        std::istringstream words(line);
        for (std::string word; words >> word;) ++page.words;
    }
    EXPECT_FALSE(fenced) << path;
    return page;
}

TEST(LessonPages, AreTenInBothLanguagesWithTheSamePartsAndCommands) {
    const std::vector<Lesson> all = lessons();
    ASSERT_EQ(all.size(), 10U);
    int number = 0;
    for (const Lesson& lesson : all) {
        EXPECT_EQ(lesson.number, ++number);
        EXPECT_TRUE(std::filesystem::exists(lesson.world)) << lesson.name;
        EXPECT_TRUE(std::filesystem::exists(lesson.configuration)) << lesson.name;
        EXPECT_FALSE(lesson.title_en.empty());
        EXPECT_FALSE(lesson.title_es.empty());
        EXPECT_NE(lesson.title_en, lesson.title_es);
        const Page english = page_of(lesson.page("en"));
        const Page spanish = page_of(lesson.page("es"));
        EXPECT_EQ(lesson.page("es_ES"), lesson.page("es"));
        EXPECT_EQ(lesson.page("fr"), lesson.page("en"));
        EXPECT_EQ(english.headings, spanish.headings) << lesson.name;
        EXPECT_EQ(english.headings.size(), 5U) << lesson.name;
        // .ci/check-docs runs those of the English pages.
        EXPECT_EQ(english.code, spanish.code) << lesson.name;
        EXPECT_THAT(english.code, testing::Contains(testing::HasSubstr("hitos-cli run")));
        EXPECT_GT(spanish.words, 200U) << lesson.name;
        EXPECT_LT(english.words, 900U) << lesson.name << ": a page, no more";
        const std::string index =
            test::content(std::filesystem::path(HITOS_SOURCE_DIR) / "docs/lessons.md");
        for (const char* language : {"en", "es"}) {
            EXPECT_THAT(index, testing::HasSubstr("../data/lessons/" + lesson.name + "/lesson." +
                                                  language + ".md"));
        }
    }
}

std::vector<std::string> in_any_language(std::vector<std::string> links) {
    const std::string spanish = "pictures/es/";
    for (std::string& link : links)
        if (link.starts_with(spanish)) link.replace(0, spanish.size(), "pictures/");
    return links;
}

TEST(GuidePages, AreTheSameInBothLanguagesPartByPart) {
    const std::filesystem::path docs = std::filesystem::path(HITOS_SOURCE_DIR) / "docs";
    const Page english = page_of(docs / "user-guide.md");
    const Page spanish = page_of(docs / "es" / "user-guide.md");
    EXPECT_GT(english.headings.size(), 15U);
    EXPECT_EQ(english.headings, spanish.headings);
    EXPECT_EQ(english.code, spanish.code);
    EXPECT_THAT(english.links, testing::Contains("pictures/window.png"));
    // Each page has the pictures of its own language, and one of the other.
    EXPECT_THAT(spanish.links, testing::Contains("pictures/es/window.png"));
    EXPECT_EQ(in_any_language(english.links), in_any_language(spanish.links));
    EXPECT_GT(spanish.words, english.words);
}

}  // namespace
}  // namespace hitos
