#include "report/shell/output/output_options.h"

#include "report/shell/command/option_values.h"
#include "report/shell/output/language_option.h"
#include "report/shell/output/sheet_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

namespace cli {
namespace {

// "text, csv, ... or markdown", with what is said of them, in lines of at most `width` characters.
std::string format_list(std::size_t width) {
  const auto all = report::formats();
  std::string text, line;
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::string word(all[i].name);
    if (!all[i].remark.empty()) word += fmt::format(" ({})", all[i].remark);
    if (i + 2 < all.size()) word += ",";
    if (i + 2 == all.size()) word += " or";
    if (!line.empty() && line.size() + 1 + word.size() > width)
      text += std::exchange(line, "") + "\n";
    line += (line.empty() ? "" : " ") + word;
  }
  return text + line;
}

std::string folder_files() {
  std::vector<std::string_view> names;
  for (const report::Format& format : report::formats()) {
    if (!format.file_name.empty()) names.push_back(format.file_name);
  }
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + std::string(names[i]);
  }
  return text;
}

ValueParser format_item(std::vector<OutputFormat>& target) {
  const auto parse = [&target](const std::string& text) -> std::string {
    const std::size_t equals = text.find('=');
    const std::string name = text.substr(0, equals);
    OutputFormat format{report::find_format(name), ""};
    if (format.format == nullptr) {
      std::vector<std::string_view> names;
      for (const report::Format& known : report::formats()) names.push_back(known.name);
      return one_of_message(name, names);
    }
    if (equals != std::string::npos) {
      format.file = text.substr(equals + 1);
      if (format.file.empty()) return "a file name is needed after '='";
      if (format.file == kStandardOutput) format.file.clear();
    }
    target.push_back(std::move(format));
    return "";
  };
  std::vector<std::string> words;
  for (const report::Format& known : report::formats()) words.emplace_back(known.name);
  return {parse, std::move(words)};
}

// "1:100" or "auto".
ValueParser drawing_scale(int& target) {
  return {
      [&target](const std::string& text) -> std::string {
        constexpr std::string_view kStart = "1:";
        constexpr int kMost = 100'000;
        int scale = 0;
        if (text != "auto") {
          const char* const end = text.data() + text.size();
          const bool has_start = text.starts_with(kStart);
          const auto read =
              std::from_chars(text.data() + (has_start ? kStart.size() : 0), end, scale);
          if (!has_start || read.ec != std::errc() || read.ptr != end || scale < 1 || scale > kMost)
            return fmt::format("'{}' is not a scale: 1:1 to 1:{}, such as 1:100, or auto", text,
                               kMost);
        }
        target = scale;
        return "";
      },
      {"auto", "1:20", "1:50", "1:100", "1:200", "1:500"}};
}

bool writes_html_file(const OutputOptions& options) {
  return !options.folder.empty() ||
         std::any_of(options.formats.begin(), options.formats.end(), [](const OutputFormat& item) {
           return item.format->is_html && !item.file.empty();
         });
}

}  // namespace

std::vector<Option> output_options(OutputOptions& options) {
  return {
      {"--format", "KIND[=FILE]",
       "Kind of report, and its file: " + format_list(78) +
           ". To FILE or, without it or with '-', to standard output: one kind only, and text "
           "where\n"
           "there is none. May be repeated; FILE's folder is made if needed",
       format_item(options.formats), true},
      {"--json", "", "As JSON: --format json",
       [parse = format_item(options.formats)](const std::string&) { return parse("json"); }},
      {"-o,--output", "FOLDER",
       fmt::format("Folder for reports: {}; made if needed", folder_files()),
       any_text(options.folder)},
      {"--html-split", "",
       "HTML files as an index with a page for each room, at most 24 planes on each, in\n"
       "a folder '<name>-rooms' beside it: for hundreds of planes",
       &options.html_split},
      {"--language", "LANG",
       "Words of html, pdf, xlsx, dxf, markdown and text: " + language_names() +
           "; default en. All\nother formats are English, and so are messages about the input and "
           "the texts of projects\nand rule packs",
       language_choice(options.language)},
      decimal_option(options.decimal, "html, pdf, dxf, markdown and text"),
      paper_option(options.page.paper, "pdf, and of html and xlsx when they are printed"),
      {"--detail", "FOR",
       "How much pdf and html say: client, what is sent to people, room first, or full, with what "
       "a\nchecker needs: grids, sampling, messages, hashes; default client for pdf, full for html",
       choice<report::Detail>(options.page.detail, {{"client", report::Detail::client},
                                                    {"full", report::Detail::full}})},
      {"--annex", "WHEN",
       fmt::format("Tables of all values at the end of a full pdf, and of html when it is printed: "
                   "auto, always\nor never; default auto: where there are at most {} values",
                   report::kMostAnnexValues),
       choice<report::Annex>(options.page.annex, {{"auto", report::Annex::automatic},
                                                  {"always", report::Annex::always},
                                                  {"never", report::Annex::never}})},
      {"--cover", "WHEN",
       "A cover page of pdf, and of html when it is printed: auto, always or never; default auto: "
       "of\n"
       "a full report where one project names its client, author, company or logo",
       choice<report::Cover>(options.page.cover, {{"auto", report::Cover::automatic},
                                                  {"always", report::Cover::always},
                                                  {"never", report::Cover::never}})},
      {"--datasheets", "",
       fmt::format("A photometric data sheet of each luminaire type at the end of html and pdf, at "
                   "most {} of\nthem; the photometry files are read again for it",
                   report::kMostSheets),
       [&options](const std::string&) {
         options.page.sheets = std::make_shared<SheetFiles>();
         return std::string();
       }},
      {"--scale", "OF",
       "Planes that share one colour scale in html, pdf and images: those of the project, of the\n"
       "room, or each plane for itself; default room. Shared by dim and bright planes it has\n"
       "classes (1, 1.5, 2, 3, 5 ...), else bands of equal width",
       choice<report::ScaleSharing>(options.page.scale, {{"project", report::ScaleSharing::project},
                                                         {"room", report::ScaleSharing::room},
                                                         {"plane", report::ScaleSharing::plane}})},
      {"--palette", "NAME",
       "Colours of values in html, pdf and images: cividis (dark blue to yellow, for all readers\n"
       "and for grey print) or false-colour (blue, cyan, green, yellow, red, magenta, as in\n"
       "lighting programs); default cividis. Pictures of rooms are painted by the check",
       choice<report::ColourMap>(options.page.palette,
                                 {{"cividis", report::ColourMap::cividis},
                                  {"false-colour", report::ColourMap::false_colour}})},
      {"--dxf-scale", "1:N",
       "Scale at which dxf is plotted: all its texts are 2.5 mm high then. auto: the coarsest of\n"
       "1:20 to 1:1000 at which at least half of the values have room and the plan is 150 mm "
       "long;\n"
       "default auto. Values that would overlap are on a frozen layer",
       drawing_scale(options.page.drawing.scale)},
      {"--dxf-unit", "UNIT", "Unit of lengths in dxf: m, cm, mm, in or ft; default m",
       choice<report::DrawingUnit>(options.page.drawing.unit, {{"m", report::DrawingUnit::m},
                                                               {"cm", report::DrawingUnit::cm},
                                                               {"mm", report::DrawingUnit::mm},
                                                               {"in", report::DrawingUnit::in},
                                                               {"ft", report::DrawingUnit::ft}})},
      {"--images", "",
       "With --output: a PNG, an SVG and an EXR file per plane, a PNG and an EXR file per "
       "picture too,\na PNG file of a rendered view",
       &options.images},
      {"--redact", "",
       "Reports without what tells of this machine: folders of files, also in the command\n"
       "and in messages, and names of graphics devices. The project's own names stay, as do\n"
       "versions and hashes. Reports say so",
       &options.redact}};
}

std::vector<Option> text_options(OutputOptions& options) {
  return {
      {"--passes", "HOW",
       "In text. fold: requirements of a workplace that pass share a line, and several rooms\n"
       "have a line each, and the reasons where they do not pass; list: each requirement has\n"
       "its own line; default fold",
       choice<bool>(options.lists_passes, {{"fold", false}, {"list", true}})},
      {"--notes", "",
       "In text of several rooms: also notes on method and limits, which are else only counted,\n"
       "and each warning on a terminal, where those of a kind else share a line",
       &options.shows_notes}};
}

Option color_option(ColorChoice& target) {
  return {"--color", "WHEN",
          "auto, always or never; auto obeys NO_COLOR, CLICOLOR_FORCE, TERM=dumb and the terminal",
          choice<ColorChoice>(target, {{"auto", ColorChoice::automatic},
                                       {"always", ColorChoice::always},
                                       {"never", ColorChoice::never}})};
}

std::string output_contradiction(const OutputOptions& options) {
  const auto to_stdout = std::count_if(options.formats.begin(), options.formats.end(),
                                       [](const OutputFormat& item) { return item.file.empty(); });
  if (to_stdout > 1) return kOnlyOneToStdout;
  if (options.images && options.folder.empty()) return "--images needs --output FOLDER";
  if (options.html_split && !writes_html_file(options)) {
    return "--html-split needs --output FOLDER or --format html=FILE";
  }
  return "";
}

report::Texts report_texts(const OutputOptions& options) {
  return texts_with(options.language, options.decimal);
}

std::vector<OutputFormat> planned_files(const OutputOptions& options) {
  std::vector<OutputFormat> files;
  for (const OutputFormat& format : options.formats) {
    if (!format.file.empty()) files.push_back(format);
  }
  if (options.folder.empty()) return files;
  for (const report::Format& format : report::formats()) {
    if (format.file_name.empty()) continue;
    files.push_back({&format, (std::filesystem::path(options.folder) / format.file_name).string()});
  }
  return files;
}

const report::Format* stdout_format(const OutputOptions& options) {
  for (const OutputFormat& format : options.formats) {
    if (format.file.empty()) return format.format;
  }
  return options.quiet ? nullptr : &report::formats().front();
}

}  // namespace cli
