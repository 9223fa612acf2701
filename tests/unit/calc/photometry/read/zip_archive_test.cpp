#include "calc/photometry/read/zip_archive.h"

#include "tests/support/photometry_samples.h"
#include "tests/support/zip_bytes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace calc::zip_archive_test {
namespace {

using test_support::diagnostics_text;
using test_support::with_bytes_replaced;
using test_support::zip_bytes;
using testing::ElementsAre;
using testing::HasSubstr;

// Messages of opening the archive and reading `file` from it; `bytes` gets its contents.
std::string messages(const std::string& archive_bytes, const std::string& file,
                     std::string* bytes = nullptr, const ZipLimits& limits = {}) {
  Diagnostics diagnostics;
  std::optional<ZipArchive> archive =
      ZipArchive::open(archive_bytes, "a.gldf", diagnostics, limits);
  std::optional<std::string> found;
  if (archive) found = archive->read(file);
  EXPECT_EQ(!found, diagnostics.has_errors());
  if (found && bytes != nullptr) *bytes = *found;
  return diagnostics_text(diagnostics);
}

TEST(ZipArchive, ReadsStoredAndPackedFiles) {
  for (const bool packed : {false, true}) {
    const std::string archive = zip_bytes({{"a/b.txt", "hello"}, {"empty", ""}}, packed);
    EXPECT_TRUE(looks_like_zip(archive));
    std::string bytes = "?";
    EXPECT_EQ(messages(archive, "a/b.txt", &bytes), "");
    EXPECT_EQ(bytes, "hello");
    EXPECT_EQ(messages(archive, "empty", &bytes), "");
    EXPECT_EQ(bytes, "");
  }
  EXPECT_TRUE(looks_like_zip(zip_bytes({})));
  EXPECT_FALSE(looks_like_zip("PK is a name"));
}

TEST(ZipArchive, NamesAreUtf8WhateverTheArchiveUses) {
  Diagnostics diagnostics;
  const std::string utf8 = zip_bytes({{"\xC3\xA4.ldt", "x"}, {"f/g", "y"}});
  const std::string dos = zip_bytes({{"\x84.ldt", "x"}}, true, ZIP_FL_ENC_CP437);
  EXPECT_THAT(ZipArchive::open(utf8, "a", diagnostics)->names(),
              ElementsAre("\xC3\xA4.ldt", "f/g"));
  const auto archive = ZipArchive::open(dos, "a", diagnostics);
  EXPECT_THAT(archive->names(), ElementsAre("\xC3\xA4.ldt"));
  EXPECT_TRUE(archive->has("\xC3\xA4.ldt"));
  EXPECT_FALSE(archive->has("a.ldt"));
}

TEST(ZipArchive, AbsentFilesAreNamedWithThoseThatAreThere) {
  EXPECT_EQ(messages(zip_bytes({{"ldc/b.ldt", "x"}}), "ldc/a.ldt"),
            "a.gldf: error[archive-missing]: the archive has no 'ldc/a.ldt'; it has: ldc/b.ldt\n");
  EXPECT_EQ(messages(zip_bytes({}), "x"),
            "a.gldf: error[archive-missing]: the archive has no 'x'; it has: none\n");
}

TEST(ZipArchive, RefusesNamesThatLeaveTheArchive) {
  const std::pair<const char*, const char*> cases[] = {
      {"../evil", "'../evil', which leaves the archive"},
      {"ldc/../../evil", "which leaves the archive"},
      {"ldc/..", "which leaves the archive"},
      {"/etc/passwd", "'/etc/passwd', which is absolute"},
      {"c:/evil", "which has a drive letter"},
      {"ldc\\a.ldt", "which has a backslash"},
      {"a\nb", "which has a control character"}};
  for (const auto& [name, words] : cases) {
    const std::string text = messages(zip_bytes({{"good", "x"}, {name, "y"}}), "good");
    EXPECT_THAT(text, HasSubstr("error[archive-name]"));
    EXPECT_THAT(text, HasSubstr(words));
  }
  for (const char* name : {"a", "a/b", "..a/b..", "a..b", "ab:c"})
    EXPECT_EQ(unsafe_name_reason(name), "") << name;
  EXPECT_EQ(unsafe_name_reason(""), "is empty");
}

TEST(ZipArchive, RefusesANameThatIsThereTwice) {
  const std::string archive = zip_bytes({{"product.xml", "1"}, {"product.xmk", "2"}});
  EXPECT_THAT(messages(with_bytes_replaced(archive, "product.xmk", "product.xml"), "product.xml"),
              HasSubstr("'product.xml', which occurs twice"));
}

TEST(ZipArchive, RefusesBombs) {
  const std::string bomb = zip_bytes({{"zeros", std::string(8u << 20, '\0')}});
  ASSERT_LT(bomb.size(), 20'000u);
  EXPECT_THAT(messages(bomb, "zeros"),
              HasSubstr("error[archive-size]: 'zeros' unpacks to more than"));
  ZipLimits generous;
  generous.ratio = 2000;
  EXPECT_EQ(messages(bomb, "zeros", nullptr, generous), "");
  generous.file_bytes = (8u << 20) - 1;
  EXPECT_THAT(messages(bomb, "zeros", nullptr, generous), HasSubstr("error[archive-size]"));
  generous.file_bytes = 8u << 20;
  EXPECT_EQ(messages(bomb, "zeros", nullptr, generous), "");
}

TEST(ZipArchive, SizesInHeadersAreNotBelieved) {
  const std::string archive = zip_bytes({{"zeros", std::string(0x02345678, '\0')}});
  const std::string size("\x78\x56\x34\x02", 4);
  ASSERT_NE(archive.find(size), std::string::npos);
  const std::string lie = with_bytes_replaced(archive, size, std::string("\x10\0\0\0", 4));
  EXPECT_THAT(messages(lie, "zeros"), HasSubstr("error[archive-"));
  const std::string honest = zip_bytes({{"a", "0123456789"}}, false);
  const std::string inflated =
      with_bytes_replaced(honest, std::string("\x0A\0\0\0", 4), std::string("\xFF\xFF\xFF\x7F", 4));
  EXPECT_THAT(messages(inflated, "a"), HasSubstr("error[archive-"));
}

TEST(ZipArchive, AllFilesTogetherAreLimited) {
  const std::string bytes = zip_bytes({{"a", std::string(600, 'a')}, {"b", std::string(600, 'b')}});
  Diagnostics diagnostics;
  ZipLimits limits;
  limits.total_bytes = 1000;
  auto archive = ZipArchive::open(bytes, "a.gldf", diagnostics, limits);
  EXPECT_TRUE(archive->read("a"));
  EXPECT_FALSE(archive->read("b"));
  EXPECT_EQ(diagnostics_text(diagnostics),
            "a.gldf: error[archive-size]: 'b' unpacks to more than 400 bytes; allowed: 64 MiB for "
            "each file, 1000 bytes in all, 200 times the size of the archive\n");
}

TEST(ZipArchive, EntriesAreLimited) {
  ZipLimits limits;
  limits.entries = 2;
  const test_support::ZipFiles files{{"a", ""}, {"b", ""}, {"c", ""}};
  EXPECT_EQ(messages(zip_bytes(files), "a", nullptr, limits),
            "a.gldf: error[archive-size]: the archive has 3 entries; allowed: 2\n");
  limits.entries = 3;
  EXPECT_EQ(messages(zip_bytes(files), "a", nullptr, limits), "");
}

TEST(ZipArchive, DamagedContentsAreNoticed) {
  const std::string archive = zip_bytes({{"a", "hello hello hello"}}, false);
  EXPECT_EQ(messages(with_bytes_replaced(archive, "hello hello", "hello jello"), "a"),
            "a.gldf: error[archive-entry]: 'a' cannot be unpacked: CRC error\n");
}

TEST(ZipArchive, CutArchivesAreErrors) {
  const std::string archive = zip_bytes({{"a", "hello"}, {"b/c", std::string(500, 'x')}});
  for (std::size_t length = 0; length < archive.size(); ++length)
    EXPECT_THAT(messages(archive.substr(0, length), "a"), HasSubstr("error[archive-")) << length;
}

TEST(ZipArchive, AnyChangedByteGivesContentsOrAnError) {
  const std::string archive = zip_bytes({{"a", "hello"}, {"b/c", std::string(500, 'x')}});
  for (std::size_t i = 0; i < archive.size(); ++i) {
    for (const char bits : {'\x01', '\x80', '\xFF'}) {
      std::string changed = archive;
      changed[i] = static_cast<char>(changed[i] ^ bits);
      std::string bytes = "hello";
      messages(changed, "a", &bytes);  // checks that failure and error go together
      EXPECT_EQ(bytes, "hello") << i;
    }
  }
}

}  // namespace
}  // namespace calc::zip_archive_test
