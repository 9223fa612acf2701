#include "report/result_file/redact.h"

#include "report/document/luminaire_labels.h"
#include "report/result_file/describe.h"
#include "report/result_file/message_json.h"
#include "report/result_file/result_fields.h"
#include "report/text/shell_words.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

namespace report {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kQuotes = "'\"";

bool is_one_of(char c, std::string_view set) { return set.find(c) != std::string_view::npos; }

// "c.xml" of "/a/b/c.xml", "b" of "/a/b/".
std::string last_name(std::string_view path) {
  const std::size_t end = path.find_last_not_of('/');
  if (end == std::string_view::npos) return "/";
  path = path.substr(0, end + 1);
  const std::size_t slash = path.rfind('/');
  return std::string(slash == std::string_view::npos ? path : path.substr(slash + 1));
}

// "acme/x.ies", not "W/m2" or "cd/klm".
bool is_path_like(std::string_view word) {
  const std::size_t slash = word.find('/');
  if (slash == 0 || slash == std::string_view::npos || word.starts_with("../")) return false;
  for (const std::string_view unit : {"/m2", "/m²"}) {
    if (word.find(unit) != std::string_view::npos) return false;
  }
  return slash > 3 || word.find('.', slash) != std::string_view::npos || word.rfind('/') != slash;
}

// Of a path without quotes at the start of the text. Names of folders may have blanks: it goes on
// while one of the next two words looks like the rest of a path.
std::size_t bare_length(std::string_view text) {
  constexpr std::string_view kEnds = " \t\n'\"<>(),;:";
  const auto end_of_word = [&](std::size_t begin) {
    return std::min(text.find_first_of(kEnds, begin), text.size());
  };
  std::size_t length = end_of_word(0);
  for (std::size_t end = length, skipped = 0; end < text.size() && text[end] == ' ' && skipped < 2;
       ++skipped) {
    const std::size_t begin = end + 1;
    end = end_of_word(begin);
    if (!is_path_like(text.substr(begin, end - begin))) continue;
    length = end;
    skipped = 0;
  }
  return length;
}

// A path may stand behind this character.
bool can_precede(char c) {
  const bool is_of_name = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                          (c >= '0' && c <= '9') || is_one_of(c, "/._-");
  return !is_of_name;
}

// How long the path at text[at] is; 0: there is none. Units such as "/m2" are none, and neither are
// addresses ("https://...").
std::size_t path_length(std::string_view text, std::size_t at) {
  const std::string_view rest = text.substr(at);
  if (!rest.starts_with('/') && !rest.starts_with("../")) return 0;
  const char before = at == 0 ? ' ' : text[at - 1];
  if (before == ':' && rest.starts_with("//") && !text.substr(0, at).ends_with("file:")) return 0;
  const bool is_quoted = is_one_of(before, kQuotes);
  std::size_t length = is_quoted ? rest.find(before) : std::string_view::npos;
  if (length == std::string_view::npos) length = bare_length(rest);
  const std::string_view path = rest.substr(0, length);
  if (path.find_first_not_of("./") == std::string_view::npos) return 0;
  const bool is_deep = path.find('/', 1) != std::string_view::npos;
  return is_deep || (is_quoted && rest.size() > length) ? length : 0;
}

// Files as one project's part of the report names them.
class FileNames {
 public:
  // prefix: "" or "project2/".
  FileNames(const std::string& project_path, std::string prefix)
      : folder_(project_path.substr(0, project_path.rfind('/') + 1)), prefix_(std::move(prefix)) {}

  std::string of(const std::string& file) const {
    if (file.empty() || (!prefix_.empty() && file.starts_with(prefix_))) return file;
    const fs::path normal = fs::path(file).lexically_normal();
    const fs::path folder = fs::path(folder_).lexically_normal();
    const fs::path inside = folder.empty() ? normal : normal.lexically_relative(folder);
    const bool is_inside = !inside.empty() && !inside.is_absolute() && *inside.begin() != "..";
    return is_inside ? prefix_ + inside.string() : last_name(file);
  }

  // Of files that the project names itself, relative to its folder.
  std::string of_input(const std::string& file) const {
    const bool is_own = fs::path(file).is_relative() && file.find("..") == std::string::npos;
    const bool is_new = prefix_.empty() || !file.starts_with(prefix_);
    return is_own && is_new ? prefix_ + file : of(file);
  }

  // What somebody has written may hold paths, too.
  void redact(calc::Message& message) const {
    for (calc::MessagePart& part : message.parts()) {
      if (part.kind == calc::PartKind::path) part.text = of(part.text);
      if (part.kind == calc::PartKind::words) part.text = within(part.text);
      for (calc::Message& argument : part.arguments) redact(argument);
    }
  }

  // Paths may stand anywhere in a text.
  std::string within(const std::string& text) const {
    std::string redacted;
    for (std::size_t i = 0; i < text.size();) {
      const bool can_begin = i == 0 || can_precede(text[i - 1]);
      const std::size_t in_folder = can_begin ? folder_length(text, i) : 0;
      const std::size_t whole = can_begin && in_folder == 0 ? path_length(text, i) : 0;
      if (in_folder > 0) {
        redacted += prefix_;
        i += in_folder;
      }
      if (whole > 0) redacted += last_name(std::string_view(text).substr(i, whole));
      i += whole;
      if (whole == 0 && i < text.size()) redacted += text[i++];
    }
    return redacted;
  }

 private:
  // Of the project's folder at text[at]; a relative one is only known in quotes or at the start.
  std::size_t folder_length(const std::string& text, std::size_t at) const {
    if (folder_.size() < 2 || text.compare(at, folder_.size(), folder_) != 0) return 0;
    const bool is_surely_one =
        folder_.front() == '/' || at == 0 || is_one_of(text[at - 1], kQuotes);
    return is_surely_one ? folder_.size() : 0;
  }

  std::string folder_;  // with its last '/', or ""
  std::string prefix_;
};

// paths: of the projects; names: of each, in the same order.
std::string redacted_command(const std::string& command_line, const std::vector<std::string>& paths,
                             const std::vector<FileNames>& names) {
  std::string command;
  bool is_set = false;
  for (const std::string& word : shell_words(command_line)) {
    std::string redacted = word.find('/') == std::string::npos ? word : last_name(word);
    if (is_set) {  // "PATH=VALUE": what was set stays
      const std::size_t value = std::min(word.find('='), word.size());
      redacted = word.substr(0, value) +
                 (names.empty() ? word.substr(value) : names.front().within(word.substr(value)));
    }
    is_set = word == "--set";
    for (std::size_t p = 0; p < names.size(); ++p) {
      if (word == paths[p]) redacted = names[p].of(word);
    }
    command += (command.empty() ? "" : " ") + shell_quoted(redacted);
  }
  return command;
}

// "gpu: a; cpu: b" of "gpu (NAME (version), software): a; cpu: b".
std::string redacted_backend(const std::string& backend) {
  constexpr std::string_view kStart = "gpu (";
  if (!backend.starts_with(kStart)) return backend;
  int depth = 1;
  std::size_t end = kStart.size();
  for (; end < backend.size() && depth > 0; ++end)
    depth += backend[end] == '(' ? 1 : backend[end] == ')' ? -1 : 0;
  return "gpu" + backend.substr(end);
}

// Goes through a project: texts that tell of the machine are marked in result_fields.h. What is
// there on some condition alone is redacted wherever it is.
class Redactor : public Visitor {
 public:
  Redactor(const FileNames& names, std::string project_path)
      : names_(names), project_path_(std::move(project_path)) {}

  template <class Items, class Cells>
  void rows(const char* /*key*/, const Items& /*items*/, const Cells& /*cells*/) {}

  template <class T>
  void field(const char* /*key*/, T&& value, const About& about = {}) {
    walk(value, about.holds);
  }
  template <class Fields>
  void object(const char* /*key*/, const Fields& fields, const About& about = {}) {
    if (about.presence.is_there) fields(*this);
  }
  template <class Fields>
  void if_true(const char* /*key*/, bool /*flag*/, const Fields& fields) {
    fields();
  }
  template <class First, class Second>
  void either(bool /*is_first*/, const First& first, const Second& second) {
    first();
    second();
  }

 private:
  std::string redacted(const std::string& text, Holds holds) const {
    switch (holds) {
      case Holds::text:
        return text;
      case Holds::file:
        return names_.of(text);
      case Holds::own_file:
        return text == project_path_ ? names_.of(text) : names_.of_input(text);
      case Holds::prose:
        break;
    }
    return names_.within(text);
  }

  template <class T>
  void walk(T& value, Holds holds) {
    if constexpr (kIsMessage<T>) {
      names_.redact(value);
    } else if constexpr (std::is_same_v<T, std::string>) {
      value = redacted(value, holds);
    } else if constexpr (kIsList<T>) {
      for (auto& item : value) walk(item, holds);
    } else if constexpr (kIsOptional<T>) {
      if (value) walk(*value, holds);
    } else if constexpr (std::is_class_v<T> && !kIsOptional<T> && !kIsOrNull<T> && !Vector<T> &&
                         !std::is_same_v<T, Line>) {
      describe(*this, value);
    }
  }

  const FileNames& names_;
  std::string project_path_;  // as it was
};

void redact_project(const FileNames& names, ProjectPart& project) {
  Redactor redactor(names, project.path);
  describe(redactor, project);
  // The result file has no pictures.
  for (SpacePart& space : project.spaces) {
    space.pictures.problem = names.within(space.pictures.problem);
    if (!space.pictures.device.empty()) space.pictures.device = "OpenGL";
  }
}

// paths: of the projects, before they were changed. What is gone has the names of its own folder.
void redact_revision(const std::vector<std::string>& paths, const std::vector<FileNames>& names,
                     Revision& revision) {
  const auto redact_change = [&](auto& change) {
    const std::string path = change.place.project;
    const auto found = std::find(paths.begin(), paths.end(), path);
    const FileNames own = found == paths.end()
                              ? FileNames(path, "")
                              : names[static_cast<std::size_t>(found - paths.begin())];
    Redactor redactor(own, path);
    describe(redactor, change);
  };
  for (ChangedResult& result : revision.results) redact_change(result);
  for (ChangedQuestion& question : revision.questions) redact_change(question);
  for (ChangedInput& input : revision.inputs) redact_change(input);
  for (ChangedPlane& plane : revision.planes) redact_change(plane);
  for (KnownWarnings& known : revision.known_warnings) {
    const auto found = std::find(paths.begin(), paths.end(), known.project);
    if (found == paths.end()) continue;
    known.project = names[static_cast<std::size_t>(found - paths.begin())].of(known.project);
  }
  if (revision.commits.empty()) revision.baseline = last_name(revision.baseline);
  for (calc::Message& note : revision.notes) {
    for (const FileNames& own : names) own.redact(note);
  }
  std::string& reason = revision.gate.weaker_accepted_by;
  for (const FileNames& own : names) reason = own.within(reason);
}

std::vector<FileNames> file_names(const std::vector<std::string>& paths,
                                  const Redaction& redaction) {
  std::vector<FileNames> names;
  for (std::size_t p = 0; p < paths.size(); ++p) names.emplace_back(paths[p], redaction.prefix(p));
  return names;
}

}  // namespace

Redaction::Redaction(std::vector<std::string> paths) : paths_(std::move(paths)) {
  std::map<std::string, int> uses;
  for (const std::string& path : paths_) ++uses[last_name(path)];
  for (const std::string& path : paths_) {
    const bool is_shared = uses[last_name(path)] > 1;
    prefixes_.push_back(is_shared ? "project" + std::to_string(prefixes_.size() + 1) + "/" : "");
  }
}

void Redaction::redact(DocumentFrame& frame) const {
  const std::vector<FileNames> names = file_names(paths_, *this);
  Provenance& provenance = frame.provenance;
  provenance.command_line = redacted_command(provenance.command_line, paths_, names);
  provenance.backend = redacted_backend(provenance.backend);
  provenance.is_redacted = true;
  for (std::size_t p = 0; p < names.size(); ++p) frame.paths[p] = names[p].of(frame.paths[p]);
}

void Redaction::redact(ProjectPart& project, std::size_t index) const {
  redact_project(FileNames(paths_[index], prefixes_[index]), project);
  // Rooms whose names held paths may come in another order.
  label_luminaires(project);
}

void redact(Document& document) {
  DocumentFrame frame = frame_of(document);
  const std::vector<std::string> paths = frame.paths;
  const Redaction redaction(paths);
  redaction.redact(frame);
  document.provenance = frame.provenance;
  for (std::size_t p = 0; p < paths.size(); ++p) redaction.redact(document.projects[p], p);
  if (document.revision) {
    redact_revision(paths, file_names(paths, redaction), *document.revision);
  }
}

}  // namespace report
