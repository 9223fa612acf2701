#pragma once
// Scenes given as the files of a user: their results have passed the readers of projects and
// photometry, the makers of points and the calculation.

#include "calc/base/diagnostics.h"
#include "calc/base/file_reader.h"
#include "report/tools/selftest/case.h"

#include <map>
#include <string>
#include <vector>

namespace cli::selftest {

// Reads files by name from a folder that exists only here.
class TextFiles : public calc::FileReader {
 public:
  explicit TextFiles(std::map<std::string, std::string> files) : files_(std::move(files)) {}
  calc::FileContent read_within(const std::string&, const std::string& path) const override;

 private:
  std::map<std::string, std::string> files_;
};

// Returns all errors in one line, "error[id]: message; ..."; "" = none.
std::string errors_in(const calc::Diagnostics& diagnostics);

// A point of a plane, by its place in the plane's grid or list, and its illuminance.
struct KnownPoint {
  Point point;
  double exact_lx = 0.0;
};

// Reads "project.xml", makes the points of its only plane, calculates and compares them with
// `known`, in the plane's order. known_to, widest: see Measured, both relative. `label` is before
// the points' names. A message of the readers, or points in other places, are problems.
void add_from_files(CaseResult& result, const std::map<std::string, std::string>& files,
                    const std::vector<KnownPoint>& known, const std::string& label,
                    const Effort& effort, double known_to = 0.0, double widest = 0.0);

// Does the same for own points: adds <plane file="points.csv"> to the project, whose text has "{}"
// at its place, and the file to the files.
void add_points_from_files(CaseResult& result, const std::string& project,
                           std::map<std::string, std::string> files,
                           const std::vector<KnownPoint>& known, const std::string& label,
                           const Effort& effort, double known_to = 0.0, double widest = 0.0);

}  // namespace cli::selftest
