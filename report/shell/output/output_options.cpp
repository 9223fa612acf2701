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
       "Choose the kind of report and its file; default text; repeatable. Kinds: " +
           format_list(78) +
           ". Without FILE, or with '-', it goes to standard output, which takes one kind only. "
           "The folder of FILE is made if needed",
       format_item(options.formats), true},
      {"--json", "", "Print JSON: the same as --format json",
       [parse = format_item(options.formats)](const std::string&) { return parse("json"); }},
      {"-o,--output", "FOLDER",
       fmt::format("Write reports into this folder; made if needed. Files: {}", folder_files()),
       any_text(options.folder)},
      {"--html-split", "",
       "Write HTML as an index and a page for each room, for hundreds of planes. A page has at "
       "most 24 planes. The pages are in a folder '<name>-rooms' beside the index",
       &options.html_split},
      {"--language", "LANG",
       "Choose the language of reports: " + language_names() +
           "; default en. It applies to html, pdf, xlsx, dxf, markdown and text. Other formats "
           "and messages about the input are English. Texts of projects and rule packs stay as "
           "they are",
       language_choice(options.language)},
      decimal_option(options.decimal, "html, pdf, dxf, markdown and text"),
      paper_option(options.page.paper, "pdf, and of html and xlsx when they are printed"),
      {"--detail", "FOR",
       "Choose how much pdf and html print: client or full; default client for pdf, full for html. "
       "client is a document to send, room by room. full adds what a checker needs: grids, "
       "sampling, messages and hashes",
       choice<report::Detail>(options.page.detail, {{"client", report::Detail::client},
                                                    {"full", report::Detail::full}})},
      {"--annex", "WHEN",
       fmt::format("Print tables of all values in a full pdf: auto, always or never; default auto. "
                   "They are at the end, also of html when it is printed. auto prints them where "
                   "there are at most {} values",
                   report::kMostAnnexValues),
       choice<report::Annex>(options.page.annex, {{"auto", report::Annex::automatic},
                                                  {"always", report::Annex::always},
                                                  {"never", report::Annex::never}})},
      {"--cover", "WHEN",
       "Print a cover page in pdf and printed html: auto, always or never; default auto. auto "
       "prints one in a full report if one project names its client, author, company or logo",
       choice<report::Cover>(options.page.cover, {{"auto", report::Cover::automatic},
                                                  {"always", report::Cover::always},
                                                  {"never", report::Cover::never}})},
      {"--datasheets", "",
       fmt::format("Add a photometric data sheet of each luminaire type to html and pdf, at most "
                   "{}. The photometry files are read again for it",
                   report::kMostSheets),
       [&options](const std::string&) {
         options.page.sheets = std::make_shared<SheetFiles>();
         return std::string();
       }},
      {"--scale", "OF",
       "Choose which planes share a colour scale: project, room or plane; default room. It applies "
       "to html, pdf and images. A scale shared by dim and bright planes has classes (1, 1.5, 2, "
       "3, 5 ...), others have bands of equal width",
       choice<report::ScaleSharing>(options.page.scale, {{"project", report::ScaleSharing::project},
                                                         {"room", report::ScaleSharing::room},
                                                         {"plane", report::ScaleSharing::plane}})},
      {"--palette", "NAME",
       "Choose the colours of values: cividis or false-colour; default cividis. It applies to "
       "html, pdf and images. cividis goes from dark blue to yellow, for all readers and for grey "
       "print. false-colour goes from blue to magenta, as in lighting programs. Pictures of rooms "
       "keep the colours of the check",
       choice<report::ColourMap>(options.page.palette,
                                 {{"cividis", report::ColourMap::cividis},
                                  {"false-colour", report::ColourMap::false_colour}})},
      {"--dxf-scale", "1:N",
       "Set the scale at which the dxf is plotted; default auto. Its texts are then 2.5 mm high. "
       "auto takes the coarsest of 1:20 to 1:1000 at which at least half of the values have room "
       "and the plan is 150 mm long. Values that would overlap are on a frozen layer",
       drawing_scale(options.page.drawing.scale)},
      {"--dxf-unit", "UNIT", "Set the unit of lengths in dxf: m, cm, mm, in or ft; default m",
       choice<report::DrawingUnit>(options.page.drawing.unit, {{"m", report::DrawingUnit::m},
                                                               {"cm", report::DrawingUnit::cm},
                                                               {"mm", report::DrawingUnit::mm},
                                                               {"in", report::DrawingUnit::in},
                                                               {"ft", report::DrawingUnit::ft}})},
      {"--images", "",
       "Write images into the folder of --output. Each plane gets PNG, SVG and EXR files, each "
       "room picture PNG and EXR files, and each rendered view a PNG file",
       &options.images},
      {"--redact", "",
       "Remove machine-specific details from reports: folders of files and names of graphics "
       "devices. Folders are also removed from the command and from messages. Names of the "
       "project, versions and hashes stay. Reports say that they are redacted",
       &options.redact}};
}

std::vector<Option> text_options(OutputOptions& options) {
  return {{"--passes", "HOW",
           "Choose how text prints passes: fold or list; default fold. fold: passes of a workplace "
           "share a line, and of several rooms each has a line, with the reasons where it does not "
           "pass. list: each requirement has its own line",
           choice<bool>(options.lists_passes, {{"fold", false}, {"list", true}})},
          {"--notes", "",
           "Print notes on method and limits in text of several rooms. Otherwise they are only "
           "counted. On a terminal warnings of one kind share a line without it",
           &options.shows_notes}};
}

Option color_option(ColorChoice& target) {
  return {"--color", "WHEN",
          "Colour the terminal output: auto, always or never; default auto. auto obeys NO_COLOR, "
          "CLICOLOR_FORCE, TERM=dumb and the terminal",
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
