#include "report/result_file/message_json.h"

#include "calc/base/sentences.h"
#include "report/result_file/read_json.h"
#include "report/result_file/redact.h"
#include "report/text/sentences.h"
#include "tests/support/rendered.h"
#include "tests/support/sample_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace report::message_json_test {
namespace {

using calc::Message;
using calc::say;
using calc::Sentence;

const Message kMessage =
    say<Sentence::with_one_out>(
        "L 1", say<Sentence::undecided>(Message::number("498"), Message::number("502 lx"),
                                        Message::number("500 lx"))) +
    "; " + Message::words("as agreed");

Message read_back(const nlohmann::ordered_json& parts, const std::string& text) {
  const nlohmann::json json = {{"reason", text}, {"reason_message", parts}};
  const JsonCursor at(json);
  return read_message(at["reason"], at.find("reason_message"));
}

TEST(MessageJson, IsWhatTheMessageIsMadeOf) {
  EXPECT_EQ(message_json(kMessage).dump(),
            R"([{"id":"with-one-out","arguments":[[{"words":"L 1"}],[{"id":"undecided",)"
            R"("arguments":[[{"number":"498"}],[{"number":"502 lx"}],[{"number":"500 lx"}]]}]]},)"
            R"({"glue":"; "},{"words":"as agreed"}])");
  EXPECT_TRUE(read_back(message_json(kMessage), kMessage.english()) == kMessage);
  // Whoever has changed the text finds it.
  EXPECT_TRUE(read_back(message_json(kMessage), "another") == Message::words("another"));
}

// One of two is gone: nobody knows whose parts are left.
TEST(MessageJson, OfAListIsItsTextsWhereTheirNumberDiffers) {
  const nlohmann::json json = {{"notes", {kMessage.english(), "more"}},
                               {"notes_message", nlohmann::json::array({message_json(kMessage)})}};
  const JsonCursor at(json);
  const std::vector<Message> notes = read_messages(at["notes"], at.find("notes_message"));
  ASSERT_EQ(notes.size(), 2U);
  EXPECT_TRUE(notes[0] == Message::words(kMessage.english()));
}

// A file of a later version says what this one does not know.
TEST(MessageJson, IsItsTextWhereItsPartsAreNotKnown) {
  for (const char* parts : {R"([{"id":"of-tomorrow","arguments":[]}])",
                            R"([{"id":"not-finite","arguments":[[]]}])", R"([{"colour":"red"}])"}) {
    EXPECT_TRUE(read_back(nlohmann::ordered_json::parse(parts), "as it was") ==
                Message::words("as it was"))
        << parts;
  }
  nlohmann::ordered_json deep = nlohmann::ordered_json::array();
  for (int i = 0; i < 100; ++i)
    deep = {{{"id", "failing"}, {"arguments", nlohmann::ordered_json::array({deep})}}};
  EXPECT_THROW(read_back(deep, ""), BadJson);
}

Document with_messages() {
  Document document = small_document();
  ProjectPart& project = document.projects[0];
  project.path = "/home/anna/p/a.xml";
  SpacePart& space = project.spaces[0];
  space.planes[0].findings[0].reason = kMessage;
  space.notes = {say<Sentence::mesh_room_faces>(Message::path("/home/anna/p/hall.obj"), 12.0,
                                                say<Sentence::faces_inward>()),
                 Message::words("see /home/anna/letter.txt")};
  return document;
}

TEST(MessageJson, IsInTheReadersLanguageAfterAFile) {
  std::string problem;
  const std::optional<Document> read = read_json(rendered("json", with_messages()), problem);
  ASSERT_TRUE(read) << problem;
  const SpacePart& space = read->projects[0].spaces[0];
  const Texts german(Language::german, true);
  EXPECT_EQ(sentence(german, space.planes[0].findings[0].reason),
            "bei Ausfall von „L 1“: das Intervall 498 bis 502 lx enthält den Grenzwert 500 lx; as "
            "agreed");
  ASSERT_EQ(space.notes.size(), 2U);
  EXPECT_TRUE(space.notes == with_messages().projects[0].spaces[0].notes);
}

TEST(MessageJson, HoldsNoFoldersAfterRedaction) {
  Document document = with_messages();
  redact(document);
  EXPECT_EQ(document.projects[0].spaces[0].notes[0].english(),
            "the room's surfaces come from 'hall.obj', a closed shell of 12 m³; its faces point "
            "into the room");
  EXPECT_EQ(document.projects[0].spaces[0].notes[1].english(), "see letter.txt");
  EXPECT_THAT(rendered("json", document), testing::Not(testing::HasSubstr("anna")));
}

}  // namespace
}  // namespace report::message_json_test
