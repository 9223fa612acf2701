#include "calc/photometry/read/photometry_file.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/encoding.h"
#include "calc/base/file_kind.h"
#include "calc/base/line_cursor.h"
#include "calc/base/text.h"
#include "calc/base/utf8.h"
#include "calc/base/xml_encoding.h"
#include "calc/photometry/read/eulumdat.h"
#include "calc/photometry/read/gldf.h"
#include "calc/photometry/read/ies_header.h"
#include "calc/photometry/read/ies_lm63.h"
#include "calc/photometry/read/number_stream.h"
#include "calc/photometry/read/text_encoding.h"
#include "calc/photometry/read/tm33_xml.h"
#include "calc/photometry/read/zip_archive.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace calc {
namespace {

constexpr char kDosEndOfFile = '\x1A';

// Type, symmetry and number of planes: three lines of one whole number each, at lines 2 to 4.
bool looks_like_eulumdat(std::string_view text) {
  LineCursor lines(text);
  lines.next();
  for (int i = 0; i < 3; ++i) {
    const std::optional<std::string_view> line = lines.next();
    if (!line) return false;
    const std::optional<double> value = parse_photometry_number(trim(*line));
    if (!value || *value != std::floor(*value)) return false;
  }
  return true;
}

// The same with values that are allowed. Texts of EULUMDAT may start with TILT=; an LM-63 file that
// states one number per line begins with IES or with its TILT= line.
bool is_surely_eulumdat(std::string_view text) {
  LineCursor lines(text);
  const std::optional<std::string_view> first = lines.next();
  if (!first || trim(*first).starts_with("IES")) return false;
  constexpr double kMost[] = {3.0, 4.0, 1.0e9};  // Ityp, Isym, Mc
  for (const double most : kMost) {
    const std::optional<std::string_view> line = lines.next();
    const std::optional<double> value = line ? parse_photometry_number(trim(*line)) : std::nullopt;
    if (!value || *value != std::floor(*value) || *value < 0.0 || *value > most) return false;
  }
  const std::optional<Lm63Header> header = read_lm63_header(text);
  return !header || header->tilt_line != 1 || (header->tilt != "NONE" && header->tilt != "INCLUDE");
}

// The first line of EULUMDAT may be any name, also one that looks like LM-63.
bool is_lm63(std::string_view text) {
  return (read_lm63_header(text) && !is_surely_eulumdat(text)) ||
         (trim(text.substr(0, 200)).starts_with("IES") && !looks_like_eulumdat(text));
}

std::string what_it_is(std::string_view text) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) return "the file is empty";
  if (looks_like_zip(text)) return "it is a ZIP archive inside another ZIP archive";
  return "no TILT= line, and lines 2 to 4 are not the three counts of EULUMDAT";
}

using Parser = std::optional<PhotometricWeb> (*)(std::string_view text, const std::string& name,
                                                 const PhotometryOptions& options,
                                                 Diagnostics& diagnostics);

std::optional<PhotometricWeb> parse_lm63_file(std::string_view text, const std::string& name,
                                              const PhotometryOptions& options,
                                              Diagnostics& diagnostics) {
  return parse_lm63(text, name, diagnostics, options.read_companion);
}

struct FormatReader {
  PhotometryFormatInfo info;
  KnownOptions known;
  bool (*is_it)(std::string_view text);
  Parser parse;
  bool is_container = false;  // of photometry files: asked of the bytes themselves, never nested
  bool is_xml = false;        // gets the bytes themselves: the declaration states the encoding
};

// The first that says "it is" reads. A new format is a row here, and a pair of files that reads it.
constexpr FormatReader kReaders[] = {
    {{"LM-63", "an LM-63 file", ".ies"}, {}, is_lm63, parse_lm63_file},
    {{"EULUMDAT", "an EULUMDAT file", ".ldt"},
     {.lamp_set = true},
     looks_like_eulumdat,
     parse_eulumdat},
    {{"TM-33", "a TM-33 file", ".xml"}, {.emitter = true}, looks_like_xml, parse_tm33, false, true},
    {{"GLDF", "a GLDF file", ".gldf"},
     {.lamp_set = true, .variant = true, .emitter = true},
     looks_like_zip,
     parse_gldf,
     true}};

// Archives of other programs are refused; of one that says nothing the reader says what is missing.
bool may_be_gldf(std::string_view bytes, const std::string& name, Diagnostics& diagnostics) {
  const FileKind* kind = kind_by_content(bytes);
  const FileKind* named = kind_by_name(name);
  const bool says_nothing =
      kind != nullptr && kind->is_vague && (named == nullptr || named->is_vague);
  return says_nothing || check_file_kind(bytes, name, FileUse::photometry, diagnostics);
}

std::optional<PhotometricWeb> read_as(const FormatReader& reader, std::string_view text,
                                      const std::string& name, const PhotometryOptions& options,
                                      Diagnostics& diagnostics) {
  if (!check_options(options, reader.known, reader.info.as_a_file, name, diagnostics)) {
    return std::nullopt;
  }
  return reader.parse(text, name, options, diagnostics);
}

}  // namespace

std::vector<PhotometryFormatInfo> photometry_formats() {
  std::vector<PhotometryFormatInfo> list;
  for (const FormatReader& reader : kReaders) list.push_back(reader.info);
  return list;
}

std::optional<LuminaireLight> parse_luminaire_light(std::string_view bytes, const std::string& name,
                                                    Diagnostics& diagnostics,
                                                    const PhotometryOptions& options) {
  for (const FormatReader& reader : kReaders) {
    if (reader.is_container && reader.is_it(bytes)) {
      if (!may_be_gldf(bytes, name, diagnostics)) return std::nullopt;
      if (!check_options(options, reader.known, reader.info.as_a_file, name, diagnostics)) {
        return std::nullopt;
      }
      return parse_gldf_luminaire(bytes, name, options, diagnostics);
    }
  }
  std::optional<PhotometricWeb> web = parse_text_photometry(bytes, name, diagnostics, options);
  if (!web) return std::nullopt;
  LuminaireLight light;
  light.emitters.push_back({std::move(*web), "", {}});
  return light;
}

std::vector<PhotometryOptions> photometry_choices(std::string_view bytes) {
  return looks_like_zip(bytes) ? choices_of_gldf(bytes) : std::vector<PhotometryOptions>{};
}

std::optional<PhotometricWeb> only_light(LuminaireLight light, const std::string& name,
                                         const PhotometryOptions& options,
                                         Diagnostics& diagnostics) {
  if (light.emitters.size() == 1) return std::move(light.emitters.front().web);
  std::vector<PhotometryChoice> choices;
  for (const EmitterLight& emitter : light.emitters) {
    choices.push_back({emitter.id, emitter.web.source().luminaire_name});
  }
  diagnostics.report(DiagnosticId::photometry_choice_needed, place_of_choice(options, name),
                     choices.size(), "emitters, of which only one can be used here,", "emitter",
                     list_choices(choices));
  return std::nullopt;
}

std::optional<PhotometricWeb> parse_photometry(std::string_view bytes, const std::string& name,
                                               Diagnostics& diagnostics,
                                               const PhotometryOptions& options) {
  std::optional<LuminaireLight> light = parse_luminaire_light(bytes, name, diagnostics, options);
  if (!light) return std::nullopt;
  return only_light(std::move(*light), name, options, diagnostics);
}

std::optional<PhotometricWeb> parse_text_photometry(std::string_view bytes, const std::string& name,
                                                    Diagnostics& diagnostics,
                                                    const PhotometryOptions& options) {
  const SourceLocation file{name, 0, 0};
  const auto is_photometry = [&](bool is_recognised) {
    return check_file_kind(bytes, name, FileUse::photometry, diagnostics, is_recognised);
  };
  if (encoding_of(bytes) != TextEncoding::utf8 && !is_photometry(true)) return std::nullopt;
  const DecodedText decoded = decoded_text(std::string(bytes));
  if (!decoded.problem.empty()) {
    diagnostics.report(DiagnosticId::photometry_encoding, file, decoded.problem);
    return std::nullopt;
  }
  std::string_view text = without_byte_order_mark(decoded.utf8);
  if (const std::size_t end = text.find(kDosEndOfFile); end != std::string_view::npos) {
    diagnostics.report(DiagnosticId::photometry_end_mark, file, text.size() - end - 1);
    text = text.substr(0, end);
  }
  for (const FormatReader& reader : kReaders) {
    if (!reader.is_container && reader.is_it(text)) {
      // A line of EULUMDAT may look like anything; XML says what it is.
      if (reader.is_xml && !is_photometry(true)) return std::nullopt;
      return read_as(reader, reader.is_xml ? bytes : text, name, options, diagnostics);
    }
  }
  if (!is_photometry(false)) return std::nullopt;
  std::string readable;
  for (const FormatReader& reader : kReaders) {
    const bool is_last = &reader == std::end(kReaders) - 1;
    readable += readable.empty() ? "" : is_last ? " and " : ", ";
    readable += fmt::format("{} ({})", reader.info.name, reader.info.extension);
  }
  diagnostics.report(DiagnosticId::photometry_format, file, what_it_is(text), readable);
  return std::nullopt;
}

}  // namespace calc
