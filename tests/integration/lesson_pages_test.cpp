// The pages of data/lessons: eight of them, in two languages that say the same.
#include <gmock/gmock.h>

#include <sstream>

#include "hitos/workbench/shipped_data.hpp"
#include "support.hpp"

namespace hitos {
namespace {

/// What both languages of a page must have alike, in its order.
struct Page {
    std::vector<std::string> headings;  ///< their marks: "##"
    std::vector<std::string> code;
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
            page.code.push_back(line);
        } else if (line.starts_with("#")) {
            page.headings.push_back(line.substr(0, line.find(' ')));
        }
        std::istringstream words(line);
        for (std::string word; words >> word;) ++page.words;
    }
    EXPECT_FALSE(fenced) << path;
    return page;
}

TEST(LessonPages, AreEightInBothLanguagesWithTheSamePartsAndCommands) {
    const std::vector<Lesson> all = lessons();
    ASSERT_EQ(all.size(), 8U);
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

}  // namespace
}  // namespace hitos
