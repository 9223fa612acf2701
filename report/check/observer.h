#pragma once
// Who watches a check: tells people, stops it, adds pictures. Nothing of it changes a value. Where
// spaces are checked at the same time (Run::concurrency()) several threads call at once, of
// different spaces; judged() alone is called for one space after the other, in their order.

#include "calc/radiosity/looks/solve.h"
#include "calc/scene/prepared_scene.h"
#include "calc/scene/project.h"
#include "report/document/document.h"

#include <cstddef>
#include <string>
#include <vector>

namespace check {

class Observer {
 public:
  virtual ~Observer() = default;

  // It is read, and has so many spaces.
  virtual void start_project(std::size_t /*spaces*/) {}
  virtual void start_space(const std::string& /*id*/) {}
  // Between two pieces of work of a space. False stops the check: the project is not judged.
  virtual bool go_on(const calc::SolveProgress& /*progress*/) { return true; }
  // Asked between two spaces; true stops it as well.
  virtual bool is_stopped() const { return false; }
  // The light of a space is known: of these tasks, in the order of solution.fields.
  virtual void solved(const std::string& /*project_path*/, const std::string& /*space_id*/,
                      const calc::PreparedScene& /*scene*/,
                      const std::vector<calc::PlaneTask>& /*tasks*/,
                      const calc::SpaceSolution& /*solution*/) {}
  // Whether judged() is to be called; scenes are kept until then.
  virtual bool draws_rooms() const { return false; }
  // Its verdicts too; pictures may be added to the part.
  virtual void judged(const std::string& /*project_path*/, const calc::Space& /*space*/,
                      const calc::PreparedScene& /*scene*/, report::SpacePart& /*part*/) {}
};

}  // namespace check
