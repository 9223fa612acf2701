#include "report/shell/output/pdf_places.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace cli::pdf_places_test {
namespace {

using testing::IsEmpty;
using testing::Pair;
using testing::UnorderedElementsAre;

// Three pages in a tree of two levels, as Chromium makes it, with the targets of links.
std::string three_pages(const std::string& targets) {
  return "%PDF-1.4\n"
         "1 0 obj\n<</Type /Catalog /Pages 2 0 R /Dests 7 0 R>>\nendobj\n"
         "2 0 obj\n<</Type /Pages /Count 3 /Kids [3 0 R 6 0 R]>>\nendobj\n"
         "3 0 obj\n<</Type /Pages /Parent 2 0 R /Count 2 /Kids [5 0 R 4 0 R]>>\nendobj\n"
         "4 0 obj\n<</Type /Page /Parent 3 0 R /MediaBox [0 0 9 9]>>\nendobj\n"
         "5 0 obj\n<</Type /Page /Parent 3 0 R /MediaBox [0 0 9 9]>>\nendobj\n"
         "6 0 obj\n<</Type /Page /Parent 2 0 R /MediaBox [0 0 9 9]>>\nendobj\n"
         "7 0 obj\n" +
         targets + "\nendobj\ntrailer\n<</Size 8 /Root 1 0 R>>\n%%EOF\n";
}

TEST(PdfPlaces, AreFoundByName) {
  EXPECT_THAT(places_in_pdf(three_pages("<</summary [5 0 R /XYZ 0 8 0] /p1s1 [4 0 R /XYZ 0 8 0] "
                                        "/method [6 0 R /XYZ 0 8 0]>>")),
              UnorderedElementsAre(Pair("summary", 1), Pair("p1s1", 2), Pair("method", 3)));
}

TEST(PdfPlaces, WhatCannotBeReadHasNone) {
  EXPECT_THAT(places_in_pdf(""), IsEmpty());
  EXPECT_THAT(places_in_pdf("%PDF of nothing"), IsEmpty());
  EXPECT_THAT(places_in_pdf(three_pages("null")), IsEmpty());
  EXPECT_THAT(places_in_pdf(three_pages("<</a 1 /b [] /c [9 0 R /XYZ 0 0 0]>>")), IsEmpty());
}

}  // namespace
}  // namespace cli::pdf_places_test
