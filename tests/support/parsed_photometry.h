#pragma once
// Photometry files as tests read them: the light beside every message.

#include "calc/base/diagnostics.h"
#include "calc/photometry/read/photometry_file.h"
#include "tests/support/photometry_samples.h"

#include <gtest/gtest.h>

#include <optional>
#include <stdexcept>
#include <string>

namespace test_support {

struct ParsedPhotometry {
  std::optional<calc::PhotometricWeb> web;
  std::string messages;
};

// Also checks that there is no light if and only if there is an error.
inline ParsedPhotometry parse_with_messages(const std::string& bytes, const std::string& name,
                                            const calc::PhotometryOptions& options = {}) {
  calc::Diagnostics diagnostics;
  ParsedPhotometry parsed{calc::parse_photometry(bytes, name, diagnostics, options), ""};
  parsed.messages = diagnostics_text(diagnostics);
  EXPECT_EQ(!parsed.web, diagnostics.has_errors()) << parsed.messages;
  return parsed;
}

// The light of a file that gives no message at all.
inline calc::PhotometricWeb read_silently(const std::string& bytes, const std::string& name) {
  ParsedPhotometry parsed = parse_with_messages(bytes, name);
  EXPECT_EQ(parsed.messages, "");
  if (!parsed.web) throw std::runtime_error(parsed.messages);
  return *parsed.web;
}

}  // namespace test_support
