// Verbatim messages about the file as a whole.

#include "tests/unit/calc/project/project_xml_support.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace calc::tests::project_xml_file_messages_test {
namespace {

const std::vector<MessageCase> kCases{
    {"EmptyFile", "", "dir/p.xml: error[xml-syntax]: not well-formed XML: the file is empty"},
    {"NotXml", R"(illuminance, 500 lx)",
     "dir/p.xml:1:1: error[xml-syntax]: not well-formed XML: text outside the root element"},
    {"UnclosedElement", R"(<luxgate version="1">
  <room>
</luxgate>)",
     "dir/p.xml:3:3: error[xml-syntax]: not well-formed XML: start and end tags do not match, or "
     "an element is not closed"},
    {"TextAfterTheRoot", R"(<luxgate version="1"/>
end)",
     "dir/p.xml:2:1: error[xml-syntax]: not well-formed XML: text outside the root element"},
    {"TwoRoots", R"(<luxgate version="1"/>
<luxgate version="1"/>)",
     "dir/p.xml:2:1: error[xml-syntax]: not well-formed XML: <luxgate> follows the root element, "
     "which must be the only one"},
    {"WrongRoot", R"(<project/>)",
     "dir/p.xml:1:1: error[wrong-root-element]: the root element is <project>; expected <luxgate>"},
    {"Doctype", R"(<!DOCTYPE luxgate [<!ENTITY e "x">]>
<luxgate version="1"/>)",
     "dir/p.xml:1:11: error[xml-doctype]: a DOCTYPE is not allowed; remove it, luxgate uses no "
     "entities and no DTDs"},
    {"OtherEncoding", R"(<?xml version="1.0" encoding="Shift_JIS"?>
<luxgate version="1"/>)",
     "dir/p.xml:1:31: error[xml-encoding]: the encoding cannot be read: the declaration says "
     "'Shift_JIS'; luxgate reads UTF-8 and UTF-16, and ISO-8859-1 and Windows-1252 where the "
     "declaration names them"},
    {"InvalidUtf8", "<luxgate version=\"1\"\n name=\"Gr\xFC\xDF\"/>",
     "dir/p.xml:2:10: error[xml-encoding]: the encoding cannot be read: byte 31 (0xFC) is not "
     "valid UTF-8; luxgate reads UTF-8 and UTF-16, and ISO-8859-1 and Windows-1252 where the "
     "declaration names them"},
    {"AnotherKind", "%PDF-1.4\n",
     "dir/p.xml: error[file-of-other-kind]: it is a PDF document; a luxgate project (XML) is "
     "needed here. Pictures and documents cannot be read here"},
    {"ForeignXml", "<measure>\n<schema_version>3.0</schema_version></measure>",
     "dir/p.xml:1:1: error[wrong-root-element]: the root element is <measure>; expected <luxgate>"},
    {"ControlCharacter", "<luxgate version=\"1\"\n name=\"a\x01\"/>",
     "dir/p.xml:2:9: error[xml-syntax]: not well-formed XML: control character 0x01 is not "
     "allowed; remove it"},
    {"UnknownReferenceInText", R"(<luxgate version="1"
 name="A &amp; B &uuml;"/>)",
     "dir/p.xml:2:18: error[xml-syntax]: not well-formed XML: unknown reference after '&'; "
     "allowed: &amp; &lt; &gt; &quot; &apos; and &#number;. Write a plain '&' as &amp;"},
    {"BareLessThan", R"(<luxgate version="1"
 name="a < b"/>)",
     "dir/p.xml:2:10: error[xml-syntax]: not well-formed XML: '<' in an attribute must be written "
     "&lt;"},
    {"DoubleHyphenInComment", R"(<luxgate version="1">
<!-- a -- b -->
</luxgate>)",
     "dir/p.xml:2:5: error[xml-syntax]: not well-formed XML: '--' is not allowed inside a comment"},
    {"UnknownVersion", R"(<luxgate version="2"/>)",
     "dir/p.xml:1:10: error[unknown-value]: attribute 'version' of <luxgate>: unknown value '2'; "
     "allowed: 1"},
    {"MissingVersion", R"(<luxgate/>)",
     "dir/p.xml:1:1: error[missing-attribute]: <luxgate> needs the attribute 'version'"},
    {"UnknownUnit", R"(<luxgate version="1" units="yd"/>)",
     "dir/p.xml:1:22: error[unknown-value]: attribute 'units' of <luxgate>: unknown value 'yd'; "
     "allowed: m, cm, mm, in or ft"},
};

class ProjectXmlFileMessages : public ::testing::TestWithParam<MessageCase> {};

TEST_P(ProjectXmlFileMessages, AreVerbatim) {
  const Loaded loaded = load(files_for_messages(GetParam().xml));
  EXPECT_EQ(loaded.messages, GetParam().messages);
  // Warnings alone leave a project.
  EXPECT_EQ(loaded.project.has_value(), loaded.messages.find("error[") == std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(All, ProjectXmlFileMessages, ::testing::ValuesIn(kCases), case_name);

}  // namespace
}  // namespace calc::tests::project_xml_file_messages_test
