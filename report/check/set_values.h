#pragma once
// Sets attributes of a project file to other values: in its text, so that every reader sees a
// normal project. The reader checks the values.
//
// A path is "ID.attribute": the attribute of the element with that id. If several have the id, ids
// of the elements around it come before it ("room.plane.id.attribute", any of them may be missing),
// or the name of an element does ("plane.id.attribute"). An element without an id has its name
// ("luxgate.maintenance-factor", "plane.require.at-least") or, for <dim> and <part>, its group, and
// for <zone> its role. "about.revision" is created if the project has no <about>.

#include "calc/base/diagnostics.h"
#include "calc/base/file_reader.h"

#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace check {

struct SetValue {
  std::string path, value;

  // Returns "linear.flux-lm=4000".
  std::string words() const { return path + "=" + value; }
};

// Returns whether it only sets project data on the first page of reports, and no result: no other
// element has an attribute of these names, whatever its id.
bool is_about_project(const SetValue& value);

// Returns what is wrong with a value whatever its attribute; "" = nothing.
std::string value_problem(const std::string& value);

// Reports why these projects cannot have these values: a path names nothing or several things, or
// the value cannot be set. Unreadable projects are not reported here. option: the option that
// messages name, "set".
void check_values(const std::vector<std::string>& projects, const std::vector<SetValue>& values,
                  std::string_view option, const calc::FileReader& files,
                  calc::Diagnostics& diagnostics);

// Reads these projects with these values, in UTF-8, and every other file unchanged. The rest of a
// project and its line numbers stay; values equal to the file's are written, too. A project that
// cannot have the values cannot be read. `files` and `values` must outlive it.
class SetReader : public calc::FileReader {
 public:
  SetReader(const calc::FileReader& files, const std::vector<std::string>& projects,
            const std::vector<SetValue>& values)
      : files_(files), projects_(projects.begin(), projects.end()), values_(values) {}

  calc::FileContent read_within(const std::string& folder, const std::string& path) const override;

 private:
  const calc::FileReader& files_;
  const std::unordered_set<std::string> projects_;  // there may be 100,000
  const std::vector<SetValue>& values_;
};

}  // namespace check
