// The compiled half of the Python module; luxgate/ is the other, which users see.

#include "calc/base/diagnostics.h"
#include "calc/base/message.h"
#include "calc/base/names.h"
#include "calc/base/numbers_version.h"
#include "calc/base/text.h"
#include "report/document/document.h"
#include "report/document/program_version.h"
#include "report/formats/format.h"
#include "report/formats/write.h"
#include "report/python/checked.h"
#include "report/result_file/describe.h"
#include "report/result_file/json.h"
#include "report/result_file/message_json.h"
#include "report/result_file/result_fields.h"
#include "report/result_file/result_schema.h"
#include "report/shell/process/exit_code.h"
#include "report/text/words.h"
#include "rules/binding/project_schema.h"
#include "rules/verdict/outcome.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <nlohmann/json.hpp>

#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace python {
namespace {

using report::About;

// How often a waiting caller asks Python whether somebody has pressed Ctrl-C.
constexpr std::chrono::milliseconds kSignalPoll{50};

// What parts become: luxgate/_parts.py.
struct Makers {
  py::object part, verdict, outcome;
};

py::str text_of(std::string_view text) {
  PyObject* made =
      PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace");
  if (made == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::str>(made);
}

// [rows, columns] of doubles, which nobody changes: results are not notebooks. Owns its numbers.
class Table {
 public:
  Table(std::size_t rows, std::size_t columns)
      : array_(std::vector<py::ssize_t>{static_cast<py::ssize_t>(rows),
                                        static_cast<py::ssize_t>(columns)}),
        next_(array_.mutable_data()) {}
  explicit Table(std::size_t rows)
      : array_(static_cast<py::ssize_t>(rows)), next_(array_.mutable_data()) {}

  void add(double value) { *next_++ = value; }
  py::object result() {
    array_.attr("setflags")(py::arg("write") = false);
    return std::move(array_);
  }

 private:
  py::array_t<double> array_;
  double* next_;
};

// A number of a table; not a number stands for what the file has null for, but open ends of
// intervals stay what they are, so that comparisons with them are right.
template <class T>
double cell_of(const T& value) {
  if constexpr (report::kIsOrNull<T>) {
    return value.value == value.none ? std::nan("") : value.value;
  } else {
    return static_cast<double>(value);
  }
}
template <class T>
inline constexpr bool kIsCell = std::is_arithmetic_v<T> || report::kIsOrNull<T>;

template <class T>
py::object object_of(const Makers& makers, const T& value, const std::string& name);

// One object of the result, by its description in result_fields.h: keys are attributes. What the
// file leaves out is None here, so that every key is there.
class PartWriter : public report::Visitor {
 public:
  // name: of a part that has none of its own.
  PartWriter(const Makers& makers, std::string name) : makers_(makers), name_(std::move(name)) {}

  py::object result() { return makers_.part(name_, words_, fields_); }
  void set(const char* key, const py::object& value) { fields_[key] = value; }

  void is(const char* name, const char* words = "") {
    if (*name != '\0') name_ = name;
    words_ = words;
  }
  template <class T>
  void constant(const char* key, const T& value) {
    fields_[key] = py::cast(value);
  }
  template <class T>
  void field(const char* key, const T& value, const About& about = {}) {
    const bool is_null = !about.presence.is_there || about.null_if.value_or(false);
    fields_[key] = is_null ? absent<T>(about) : object_of(makers_, value, child(key));
    if constexpr (report::kIsMessage<T> || report::kIsMessageList<T>) {
      const bool has_parts = !is_null && report::has_parts(value);
      fields_[report::message_key(key).c_str()] = has_parts ? parts_of(value) : py::none();
    }
  }
  template <class Make, class Choices = int>
  void written(const char* key, const Make& make, const About& about = {},
               const Choices& /*choices*/ = {}) {
    if (!about.presence.is_there) {
      fields_[key] = py::none();
      return;
    }
    fields_[key] = object_of(makers_, make(), child(key));
  }
  template <class Fields>
  void object(const char* key, const Fields& fields, const About& about = {}) {
    if (!about.presence.is_there) {
      fields_[key] = py::none();
      return;
    }
    PartWriter writer(makers_, child(key));
    fields(writer);
    fields_[key] = writer.result();
  }
  template <class Items, class Cells>
  void rows(const char* key, const Items& items, const Cells& cells) {
    Rows rows(makers_, items.size());
    for (const auto& item : items) cells(rows, item);
    fields_[key] = rows.result();
  }

 private:
  // Numbers alone make a table, other rows are tuples.
  class Rows {
   public:
    Rows(const Makers& makers, std::size_t count) : makers_(makers), count_(count) {}

    template <class... Cell>
    void operator()(const Cell&... cell) {
      if constexpr ((kIsCell<Cell> && ...)) {
        if (!table_) table_.emplace(count_, sizeof...(Cell));
        (table_->add(cell_of(cell)), ...);
      } else {
        others_.append(py::make_tuple(object_of(makers_, cell, "")...));
      }
    }
    void refuse_if(bool /*is_bad*/, const char* /*words*/) {}
    py::object result() { return table_ ? table_->result() : py::tuple(others_); }

   private:
    const Makers& makers_;
    std::size_t count_;
    std::optional<Table> table_;
    py::list others_;
  };

  std::string child(const char* key) const { return name_ + "_" + key; }

  // Lists and dicts, as the file has them.
  template <class T>
  static py::object parts_of(const T& message) {
    using Json = nlohmann::ordered_json;
    return py::module_::import("json").attr("loads")(text_of(
        report::message_json(message).dump(-1, ' ', false, Json::error_handler_t::replace)));
  }

  // A mark is false where it is not there, and a list is empty.
  template <class T>
  py::object absent(const About& about) const {
    if (about.is_mark) return py::bool_(false);
    if constexpr (report::kIsList<T>) {
      if (!about.null_if.value_or(false)) return object_of(makers_, T{}, "");
    }
    return py::none();
  }

  const Makers& makers_;
  std::string name_;
  const char* words_ = "";
  py::dict fields_;
};

// What a part says besides its keys.
void add_to(PartWriter& writer, const Makers& makers, const rules::Finding& finding) {
  writer.set("words", text_of(report::quantity_words(finding.requirement)));
  writer.set("outcome", makers.outcome(text_of(calc::name_of(rules::outcome_of(finding)))));
}
void add_to(PartWriter& writer, const Makers& makers, const rules::AggregateFinding& finding) {
  writer.set("outcome", makers.outcome(text_of(calc::name_of(rules::outcome_of(finding)))));
}
void add_to(PartWriter& writer, const Makers& /*makers*/, const report::PlanePart& plane) {
  writer.set("unit", text_of(calc::unit_of(plane.derived)));
}
void add_to(PartWriter& writer, const Makers& /*makers*/, const calc::Diagnostic& diagnostic) {
  writer.set("formatted", text_of(calc::format_diagnostic(diagnostic)));
}
void add_to(PartWriter& writer, const Makers& makers, const report::ProjectPart& project) {
  writer.set("outcome", makers.outcome(text_of(calc::name_of(report::outcome_of(project)))));
}
template <class T>
void add_to(PartWriter& /*writer*/, const Makers& /*makers*/, const T& /*part*/) {}

py::object table_of(const std::vector<double>& numbers) {
  Table table(numbers.size());
  for (const double number : numbers) table.add(number);
  return table.result();
}
py::object table_of(const std::vector<glm::dvec2>& places) {
  Table table(places.size(), 2);
  for (const glm::dvec2& place : places) {
    table.add(place.x);
    table.add(place.y);
  }
  return table.result();
}
template <class T>
concept MakesTable =
    std::is_same_v<T, std::vector<double>> || std::is_same_v<T, std::vector<glm::dvec2>>;

template <class T>
py::object object_of(const Makers& makers, const T& value, const std::string& name) {
  if constexpr (report::kIsOrNull<T>) {
    const bool is_none = value.value == value.none || std::isnan(value.value);
    return is_none ? py::object(py::none()) : py::object(py::float_(value.value));
  } else if constexpr (report::kIsOptional<T>) {
    return value ? object_of(makers, *value, name) : py::none();
  } else if constexpr (std::is_same_v<T, glm::dvec3>) {
    return py::make_tuple(value.x, value.y, value.z);
  } else if constexpr (std::is_same_v<T, glm::dvec2>) {
    return py::make_tuple(value.x, value.y);
  } else if constexpr (std::is_same_v<T, report::Line>) {
    return py::make_tuple(value[0].x, value[0].y, value[1].x, value[1].y);
  } else if constexpr (MakesTable<T>) {
    return table_of(value);
  } else if constexpr (report::kIsList<T>) {
    py::tuple list(value.size());
    for (std::size_t i = 0; i < value.size(); ++i) list[i] = object_of(makers, value[i], name);
    return list;
  } else if constexpr (std::is_same_v<T, rules::Verdict>) {
    return makers.verdict(text_of(calc::name_of(value)));
  } else if constexpr (std::is_same_v<T, rules::Outcome>) {
    return makers.outcome(text_of(calc::name_of(value)));
  } else if constexpr (report::Named<T>) {
    return text_of(calc::name_of(value));
  } else if constexpr (std::is_same_v<T, calc::Message>) {
    return text_of(value.english());
  } else if constexpr (std::is_convertible_v<T, std::string_view>) {
    return text_of(value);
  } else if constexpr (std::is_class_v<T>) {
    PartWriter writer(makers, name);
    describe(writer, value);
    add_to(writer, makers, value);
    return writer.result();
  } else {
    return py::cast(value);
  }
}

Makers makers() {
  const py::module_ parts = py::module_::import("luxgate._parts");
  return {parts.attr("make_part"), parts.attr("Verdict"), parts.attr("Outcome")};
}

// A finished document. Nothing changes it, so that threads may share it.
struct Handle {
  std::shared_ptr<const report::Document> document;

  py::object parts() const { return object_of(makers(), *document, "document"); }
  std::string outcome() const { return std::string(calc::name_of(outcome_of(*document))); }
  int exit_code() const { return cli::exit_code_of(outcome_of(*document)); }
  bool is_judged() const {
    for (const report::ProjectPart& project : document->projects) {
      if (!project.is_judged) return false;
    }
    return true;
  }
};

using Settings = std::vector<std::pair<std::string, std::string>>;

std::vector<Setting> settings_of(const Settings& pairs) {
  std::vector<Setting> settings;
  for (const auto& [option, text] : pairs) settings.push_back({option, text});
  return settings;
}

// (document or None, messages of the run, what is wrong with the settings or "")
py::tuple tuple_of(Checked checked) {
  py::object document = py::none();
  if (checked.document) {
    document =
        py::cast(Handle{std::make_shared<const report::Document>(*std::move(checked.document))});
  }
  return py::make_tuple(document, object_of(makers(), checked.messages, ""), checked.problem);
}

// Calculates on a thread of its own, so that the caller can ask Python for signals meanwhile.
py::tuple run_check(const std::string& path, const Settings& pairs) {
  const std::vector<Setting> settings = settings_of(pairs);
  std::atomic<bool> is_stopped{false};
  std::optional<py::error_already_set> signal;
  std::exception_ptr failure;
  Checked checked;
  {
    const py::gil_scoped_release released;
    std::mutex mutex;
    std::condition_variable changed;
    bool is_done = false;
    std::thread worker([&] {
      try {
        checked = check(path, settings, [&] { return !is_stopped.load(); });
      } catch (...) {
        failure = std::current_exception();
      }
      const std::scoped_lock lock(mutex);
      is_done = true;
      changed.notify_all();
    });
    std::unique_lock lock(mutex);
    while (!changed.wait_for(lock, kSignalPoll, [&] { return is_done; })) {
      lock.unlock();
      {
        const py::gil_scoped_acquire acquired;
        if (!signal && PyErr_CheckSignals() != 0) {
          signal.emplace();
          is_stopped.store(true);
        }
      }
      lock.lock();
    }
    lock.unlock();
    worker.join();
  }
  if (signal) throw py::error_already_set(*signal);
  if (failure) std::rethrow_exception(failure);
  return tuple_of(std::move(checked));
}

py::tuple run_validate(const std::string& path, const Settings& pairs) {
  Checked checked;
  {
    const py::gil_scoped_release released;
    checked = validate(path, settings_of(pairs));
  }
  return tuple_of(std::move(checked));
}

py::tuple run_read(const std::string& path) {
  Checked checked;
  {
    const py::gil_scoped_release released;
    checked = read_result(path);
  }
  return tuple_of(std::move(checked));
}

py::tuple run_parse(const std::string& bytes) {
  Checked checked;
  {
    const py::gil_scoped_release released;
    checked = read_result_bytes("result", bytes);
  }
  return tuple_of(std::move(checked));
}

// (bytes, what is wrong or "")
py::tuple run_render(const Handle& handle, const std::string& format, const Settings& pairs) {
  std::string bytes, problem;
  {
    const py::gil_scoped_release released;
    bytes = rendered(*handle.document, format, settings_of(pairs), problem);
  }
  return py::make_tuple(py::bytes(bytes), problem);
}

// "" or why not.
std::string run_write(const std::string& path, const std::string& bytes) {
  const py::gil_scoped_release released;
  return report::write_file_atomically(path, bytes);
}

// (name, value name, help, is a flag, may have a value, repeats)
using OptionRow = std::tuple<std::string, std::string, std::string, bool, bool, bool>;
std::vector<OptionRow> options(const std::string& use) {
  const Use wanted = use == "check" ? Use::check : use == "validate" ? Use::validate : Use::write;
  std::vector<OptionRow> rows;
  for (const OfferedOption& option : offered_options(wanted)) {
    rows.emplace_back(option.name, option.value_name, option.help, option.is_flag,
                      option.may_have_value, option.repeats);
  }
  return rows;
}

template <class Enum>
std::vector<std::string> names() {
  std::vector<std::string> list;
  for (const std::string_view name : calc::names_of<Enum>()) list.emplace_back(name);
  return list;
}

std::vector<std::string> format_names() {
  std::vector<std::string> list;
  for (const report::Format& format : report::formats()) {
    if (!format.is_printed) list.emplace_back(format.name);
  }
  return list;
}

std::string suggestion(const std::string& found, const std::vector<std::string>& choices) {
  return calc::suggestion(found, {choices.begin(), choices.end()});
}

}  // namespace

PYBIND11_MODULE(_luxgate, m) {
  m.doc() = "The compiled half of luxgate; use the module luxgate.";
  py::class_<Handle>(m, "Document")
      .def("parts", &Handle::parts)
      .def("outcome", &Handle::outcome)
      .def("exit_code", &Handle::exit_code)
      .def("is_judged", &Handle::is_judged)
      .def("render", &run_render);
  m.def("check", &run_check);
  m.def("validate", &run_validate);
  m.def("read", &run_read);
  m.def("parse", &run_parse);
  m.def("write", &run_write);
  m.def("options", &options);
  m.def("known_options", &known_options);
  m.def("suggestion", &suggestion);
  m.def("formats", &format_names);
  m.def("verdicts", &names<rules::Verdict>);
  m.def("outcomes", &names<rules::Outcome>);
  m.def("project_schema", &rules::project_schema);
  m.def("result_schema", &report::result_schema);
  m.attr("version") = report::program_version();
  m.attr("numbers_version") = calc::kNumbersVersion;
}

}  // namespace python
