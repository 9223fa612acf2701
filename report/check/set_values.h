#pragma once
// Attributes of a project file that are given another value than the file has: in its text, so that
// whoever reads it sees a project like any other. Values are judged by that reader.
//
// A path is "ID.attribute": the attribute of the element of that id. Where several have the id,
// those of the elements around it stand before it ("room.plane.id.attribute", any of them may be
// left out), or the name of an element does ("plane.id.attribute"). An element without an id goes
// by its name ("luxgate.maintenance-factor", "plane.require.at-least") or, of <dim> and <part>, by
// its group, and of <zone> by its role. "about.revision" is made where the project has no <about>.

#include "calc/base/diagnostics.h"
#include "calc/base/file_reader.h"

#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace check {

struct SetValue {
  std::string path, value;

  // "linear.flux-lm=4000"
  std::string words() const { return path + "=" + value; }
};

// Whether it sets what reports say on their first page, and so no result: no other element has an
// attribute of these names, whatever ids there are.
bool is_about_project(const SetValue& value);

// What is wrong with a value whatever it is for; "" = nothing.
std::string value_problem(const std::string& value);

// Reports why these projects cannot have these values: a path that names nothing or several things,
// or what cannot be set. Projects that are not readable are no error of this. option: as whose
// argument messages name a path, "set".
void check_values(const std::vector<std::string>& projects, const std::vector<SetValue>& values,
                  std::string_view option, const calc::FileReader& files,
                  calc::Diagnostics& diagnostics);

// Gives these projects with these values, in UTF-8, and every other file as it is. Everything else
// of a project stays, and so do the numbers of lines; values that are its own are written, too. A
// project that cannot have them cannot be read. `files` and `values` outlive it.
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
