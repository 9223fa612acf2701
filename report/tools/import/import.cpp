#include "report/tools/import/import.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/file_reader.h"
#include "report/formats/write.h"
#include "report/shell/command/help_text.h"
#include "report/shell/command/option_values.h"
#include "report/shell/process/print.h"
#include "report/stream/sink.h"
#include "report/tools/import/design_notes.h"
#include "report/tools/import/dxf_design.h"
#include "report/tools/import/dxf_drawing.h"
#include "report/tools/import/ifc_import.h"
#include "report/tools/import/import_kind.h"
#include "report/tools/import/import_map.h"
#include "report/tools/import/import_report.h"
#include "report/tools/import/project_merge.h"
#include "report/tools/import/project_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <system_error>
#include <utility>
#include <vector>

namespace cli {
namespace {

namespace fs = std::filesystem;
using calc::DiagnosticId;

constexpr const char* kProject = "project.xml";
constexpr const char* kLastImport = ".luxgate-import.xml";
constexpr const char* kPhotometry = "photometry";

// A file that is to be written.
struct NewFile {
  std::string path, bytes;
};

std::optional<Design> read_design(const std::string& bytes, const ImportOptions& options,
                                  const ImportMap& map, calc::Diagnostics& diagnostics) {
  const calc::SourceLocation where{options.file, 0, 0};
  std::string problem;
  std::optional<Design> design;
  if (is_read_as_ifc(bytes)) {
    design = design_of_ifc(bytes, options.file, map, options.unit, problem);
  } else if (const std::optional<DxfDrawing> drawing = read_dxf(bytes, problem)) {
    design = design_of_dxf(*drawing, options.file, map, options.unit, problem);
  } else {
    problem = unread_drawing(bytes, options.file, problem);
  }
  if (!design) diagnostics.report(DiagnosticId::file_of_other_kind, where, problem);
  return design;
}

// The path of a file of the map, from here.
fs::path beside_map(const ImportMap& map, const std::string& name) {
  return (fs::path(map.file).parent_path() / name).lexically_normal();
}

// Of each [[luminaire]] its photometry as the project is to name it, "" where it cannot be had. A
// file within the project's folder is named as it is, others are copied into its photometry/: a
// project reads files of its own folder alone.
std::vector<std::string> plan_photometry(const ImportMap& map, const std::string& folder,
                                         std::vector<NewFile>& files, DesignNotes& notes) {
  std::vector<std::string> names;
  std::set<std::string> taken;
  const calc::DiskFileReader reader;
  std::error_code failure;
  const fs::path top = fs::weakly_canonical(folder.empty() ? "." : folder, failure);
  for (const MapLuminaire& rule : map.luminaire) {
    const std::string place = fmt::format("map line {}", rule.line);
    const fs::path source = beside_map(map, rule.photometry);
    calc::FileContent content = reader.read(source.string());
    if (!content.ok()) {
      notes.left_out(fmt::format("photometry '{}'", rule.photometry), content.error, place);
      names.emplace_back();
      continue;
    }
    const fs::path within = fs::weakly_canonical(source, failure).lexically_relative(top);
    if (!failure && !within.empty() && *within.begin() != "..") {
      names.push_back(within.generic_string());
      continue;
    }
    const std::string name = (fs::path(kPhotometry) / source.filename()).generic_string();
    const std::string target = (fs::path(folder) / name).string();
    const auto planned = std::find_if(files.begin(), files.end(),
                                      [&](const NewFile& file) { return file.path == target; });
    const calc::FileContent there = reader.read(target);
    const bool is_other = planned != files.end() ? planned->bytes != content.bytes
                                                 : there.ok() && there.bytes != content.bytes;
    names.push_back(name);
    if (is_other) {
      notes.left_out(fmt::format("photometry '{}'", rule.photometry),
                     fmt::format("the project has another '{}': it is kept, and used", name),
                     place);
    } else if (planned == files.end() && !there.ok()) {
      files.push_back({target, std::move(content.bytes)});
    }
  }
  return names;
}

// Meshes that the project names: their names say what is in them, so that one that is there with
// other contents was changed by hand.
void plan_meshes(const ProjectText& project, const std::string& folder, std::vector<NewFile>& files,
                 DesignNotes& notes) {
  const calc::DiskFileReader reader;
  for (const ProjectText::File& file : project.file) {
    const std::string target = (fs::path(folder) / file.name).string();
    const calc::FileContent there = reader.read(target);
    if (!there.ok()) {
      files.push_back({target, file.bytes});
    } else if (there.bytes != file.bytes) {
      notes.doubt(fmt::format("mesh '{}'", file.name),
                  "it was changed by hand: it is kept, and used");
    }
  }
}

// "" or why not all could be written.
std::string write_all(const std::vector<NewFile>& files, std::vector<std::string>& written) {
  report::FileSet set;
  for (const NewFile& file : files) {
    const std::string problem =
        set.add(file.path, [&](report::Sink& sink) { sink.write(file.bytes); });
    if (!problem.empty()) return fmt::format("cannot write '{}': {}", file.path, problem);
  }
  const std::vector<std::string> problems = set.publish(written);
  return problems.empty() ? "" : problems.front();
}

// The project as it is to be, merged with what is there. False after an error.
bool plan_project(const std::string& folder, const std::string& imported,
                  std::vector<NewFile>& files, ImportReport& report,
                  calc::Diagnostics& diagnostics) {
  const std::string project = (fs::path(folder) / kProject).string();
  const std::string last = (fs::path(folder) / kLastImport).string();
  const calc::DiskFileReader reader;
  std::error_code ignored;
  const bool has_project = fs::exists(fs::symlink_status(project, ignored));
  const bool has_last = fs::exists(fs::symlink_status(last, ignored));
  files.push_back({last, imported});
  if (!has_project) {
    files.push_back({project, imported});
    return true;
  }
  const calc::FileContent mine = reader.read(project);
  const calc::FileContent base = has_last ? reader.read(last) : calc::FileContent{};
  for (const auto& [content, path] : {std::pair(&mine, &project), std::pair(&base, &last)}) {
    if (content->ok()) continue;
    diagnostics.report(DiagnosticId::file_not_readable, {*path, 0, 0}, *path, content->error);
    return false;
  }
  if (!has_last) {
    diagnostics.report(DiagnosticId::output_not_possible, {project, 0, 0},
                       fmt::format("it exists already, and no import made it ('{}' is missing): "
                                   "nothing was written; name another folder",
                                   last));
    return false;
  }
  std::optional<MergedProject> merged =
      merge_projects({base.bytes, last}, {mine.bytes, project}, imported, diagnostics);
  if (!merged) return false;
  report.changes = std::move(merged->changes);
  report.conflicts = std::move(merged->conflicts);
  if (merged->xml != mine.bytes) files.push_back({project, std::move(merged->xml)});
  return true;
}

ExitCode run_suggest(const ImportOptions& options, const std::string& bytes) {
  std::string problem;
  std::optional<std::string> map;
  if (is_read_as_ifc(bytes)) {
    map = suggest_ifc_map(bytes, options.file, options.unit, problem);
  } else if (const std::optional<DxfDrawing> drawing = read_dxf(bytes, problem)) {
    map = suggest_map(*drawing, options.file);
  } else {
    problem = unread_drawing(bytes, options.file, problem);
  }
  CommandOutcome outcome;
  if (map) {
    outcome.text = std::move(*map);
    return print_outcome(outcome);
  }
  calc::Diagnostics diagnostics;
  diagnostics.report(DiagnosticId::file_of_other_kind, {options.file, 0, 0}, problem);
  return print_outcome({kNotJudged, "", diagnostics.all()});
}

ExitCode run_import(const ImportOptions& options) {
  calc::Diagnostics diagnostics;
  const calc::DiskFileReader reader;
  const auto failed = [&] { return print_outcome({kNotJudged, "", diagnostics.all()}); };
  const auto read = [&](const std::string& path) {
    calc::FileContent content = reader.read(path);
    if (!content.ok()) {
      diagnostics.report(DiagnosticId::file_not_readable, {path, 0, 0}, path, content.error);
    }
    return content;
  };
  const calc::FileContent plan = read(options.file);
  if (!plan.ok()) return failed();
  if (const std::string other = import_kind_problem(plan.bytes, options.file); !other.empty()) {
    diagnostics.report(DiagnosticId::file_of_other_kind, {options.file, 0, 0}, other);
    return failed();
  }
  if (options.suggests_map) return run_suggest(options, plan.bytes);
  if (options.map.empty()) {
    const auto* needed = "--map FILE.toml is needed; --suggest-map prints one to start from";
    tell("{}", usage_error_text(needed, "luxgate import"));
    return kNotJudged;
  }
  const calc::FileContent map_file = read(options.map);
  if (!map_file.ok()) return failed();
  const std::optional<ImportMap> map = read_import_map(map_file.bytes, options.map, diagnostics);
  if (!map) return failed();
  if (map->room.empty()) {
    diagnostics.report(DiagnosticId::config_value, {options.map, 0, 0}, "room",
                       "at least one [[room]] is needed: everything else is in a room");
    return failed();
  }
  std::optional<Design> design = read_design(plan.bytes, options, *map, diagnostics);
  if (!design) return failed();

  std::vector<NewFile> files;
  DesignNotes notes(*design);
  const std::vector<std::string> photometry = plan_photometry(*map, options.folder, files, notes);
  const ProjectText project = project_text(*design, *map, photometry);
  plan_meshes(project, options.folder, files, notes);
  ImportReport report{&*design, &project, {}, {}, {}};
  if (!options.folder.empty()) {
    if (!plan_project(options.folder, project.xml, files, report, diagnostics)) return failed();
    const std::string problem = write_all(files, report.written);
    if (!problem.empty()) {
      diagnostics.report(DiagnosticId::output_not_possible, {options.folder, 0, 0}, problem);
      return failed();
    }
  }
  CommandOutcome outcome;
  outcome.text = options.as_json ? import_as_json(report) : import_as_text(report);
  const bool is_all = report.conflicts.empty() &&
                      std::none_of(design->note.begin(), design->note.end(), [](const auto& note) {
                        return note.kind == DesignNote::Kind::left_out;
                      });
  outcome.code = is_all ? kAllMet : kNotMet;
  const ExitCode code = print_outcome(outcome);
  tell_written(report.written);
  if (options.folder.empty()) tell("luxgate: nothing was written: give -o FOLDER\n");
  return code;
}

}  // namespace

Command import_command() {
  const auto options = std::make_shared<ImportOptions>();
  Command command{"import", "Begin a project from a plan (DXF, IFC), or take over what changed"};
  command.places = {{"plan", "PLAN",
                     "A drawing (DXF, text or binary, any version) or a model (IFC 2x3 or 4)",
                     &options->file}};
  command.options = {
      {"--map", "FILE.toml", "Read what layers and blocks mean, and what no drawing knows; needed",
       some_text(options->map)},
      {"-o,--output", "FOLDER",
       "Write the project into this folder; made if needed. Without it nothing is written",
       some_text(options->folder)},
      {"--suggest-map", "", "Print a map to start from: all layers and blocks, or rooms and types",
       &options->suggests_map},
      {"--unit", "UNIT",
       "Set the unit of the drawing: m, cm, mm, in or ft. It overrides the map and the file",
       ValueParser(
           [target = options](const std::string& text) -> std::string {
             if (!metres_per_import_unit(text)) return one_of_message(text, kImportUnits);
             target->unit = text;
             return "";
           },
           {kImportUnits.begin(), kImportUnits.end()})}};
  add(command.options, text_or_json_options(options->as_json));
  command.notes =
      "The map says what closed outlines, blocks and polylines become: rooms, luminaires,\n"
      "furniture, planes and routes. What could not be taken is listed with its reason.\n\n"
      "FOLDER gets project.xml, photometry/ and .luxgate-import.xml, a copy of what the drawing\n"
      "said. The next import compares this copy with the drawing and with project.xml. Changes of\n"
      "the drawing are taken over, changes by hand are kept.";
  command.examples = {{"luxgate import plan.dxf --suggest-map > map.toml", "Then: edit map.toml"},
                      {"luxgate import plan.dxf --map map.toml -o project",
                       "Then: luxgate validate project/project.xml"}};
  command.exit_codes = {
      {0, "everything that the map names was taken"},
      {1, "something was not taken, or was also changed by hand; the report lists it"},
      {2, "an error; nothing was written"}};
  command.complete = [options](const Environment&) -> std::string {
    if (!options->suggests_map) return "";
    const bool is_alone = options->map.empty() && options->folder.empty() && !options->as_json;
    return is_alone ? "" : "--suggest-map cannot be used with --map, --output or JSON";
  };
  command.run = [options](const RunContext&) { return run_import(*options); };
  return command;
}

}  // namespace cli
