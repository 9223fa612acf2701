#include "calc/base/message.h"

#include "calc/base/sentences.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace calc::message_test {
namespace {

TEST(Message, IsEnglishByItself) {
  EXPECT_EQ(Message().english(), "");
  EXPECT_EQ(say<Sentence::no_such_look>(Message::number("(1, 2, 3) m"), "up", "none").english(),
            "no calculation point at (1, 2, 3) m looks towards up; directions there: none");
  // Numbers have the format of the text.
  EXPECT_EQ(say<Sentence::light_beyond_table>("lamp", 12.345).english(),
            "the photometric table of luminaire type 'lamp' ends while its intensity is still 12 "
            "% of the maximum; the light beyond is not known, so there may be more light");
}

TEST(Message, JoinsWhatIsThere) {
  Message message;
  append(message, {});
  EXPECT_TRUE(message.empty());
  append(message, Message::words("a"));
  append(message, {});
  append(message, Message::words("b"));
  EXPECT_EQ(message.english(), "a; b");
  EXPECT_EQ(joined({message, {}, Message::words("c")}, ", ").english(), "a; b, c");
  message += message;
  EXPECT_EQ(message.english(), "a; ba; b");
}

TEST(Message, NamesSoManyAtMost) {
  EXPECT_EQ(names_message({}, 2).english(), "");
  EXPECT_EQ(names_message({"a", "b"}, 2).english(), "a, b");
  EXPECT_EQ(names_message({"a", "b", "c", "d"}, 2).english(), "a, b and 2 more");
}

TEST(Message, KnowsWhatItSays) {
  const Message message = say<Sentence::with_one_out>("a", say<Sentence::not_finite>()) + "; " +
                          say<Sentence::area_unknown>();
  EXPECT_TRUE(says(message, Sentence::with_one_out));
  EXPECT_TRUE(says(message, Sentence::area_unknown));
  EXPECT_FALSE(says(message, Sentence::not_finite));  // another one does
}

TEST(Message, IsWhatItHolds) {
  const Message a = say<Sentence::no_scene>("night");
  EXPECT_TRUE(a == say<Sentence::no_scene>("night"));
  EXPECT_FALSE(a == say<Sentence::no_scene>("day"));
  EXPECT_FALSE(a == Message::words(a.english()));
  EXPECT_FALSE(Message::words("1") == Message::number("1"));
  EXPECT_TRUE((a < say<Sentence::no_scene>("day")) != (say<Sentence::no_scene>("day") < a));
}

TEST(Message, HasIdsWithNames) {
  EXPECT_EQ(sentence_name(Sentence::light_is_lost), "light-is-lost");
  EXPECT_EQ(sentence_from_name("light-is-lost"), Sentence::light_is_lost);
  EXPECT_FALSE(sentence_from_name("light-is-found"));
}

TEST(SentenceTemplate, KnowsItsPlaceholders) {
  const SentenceTemplate found = sentence_template("a {1} b {0:.2f}{}");
  ASSERT_EQ(found.placeholders.size(), 3U);
  EXPECT_EQ(found.placeholders[0].argument, 1U);
  EXPECT_EQ(found.placeholders[1].argument, 0U);
  EXPECT_EQ(found.placeholders[1].format, "{0:.2f}");
  EXPECT_EQ(found.placeholders[2].argument, 2U);
  EXPECT_EQ(found.literals, (std::vector<std::string_view>{"a ", " b ", "", ""}));
}

}  // namespace
}  // namespace calc::message_test
