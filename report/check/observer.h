#pragma once
// Observers of a check: they inform people, stop it, or add pictures, and never change a value. If
// spaces are checked at the same time (Run::concurrency()), several threads call for different
// spaces; only judged() is called for one space after the other, in their order.

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

  // Called when the project is read, with its number of spaces.
  virtual void start_project(std::size_t /*spaces*/) {}
  virtual void start_space(const std::string& /*id*/) {}
  // Called between pieces of work of a space. False stops the check: the project is not judged.
  virtual bool go_on(const calc::SolveProgress& /*progress*/) { return true; }
  // Called between two spaces; true stops the check, too.
  virtual bool is_stopped() const { return false; }
  // Called when the light of a space is known, with its tasks in the order of solution.fields.
  virtual void solved(const std::string& /*project_path*/, const std::string& /*space_id*/,
                      const calc::PreparedScene& /*scene*/,
                      const std::vector<calc::PlaneTask>& /*tasks*/,
                      const calc::SpaceSolution& /*solution*/) {}
  // Returns whether judged() is to be called; scenes are kept until then.
  virtual bool draws_rooms() const { return false; }
  // Called with the verdicts of a space; may add pictures to the part.
  virtual void judged(const std::string& /*project_path*/, const calc::Space& /*space*/,
                      const calc::PreparedScene& /*scene*/, report::SpacePart& /*part*/) {}
};

}  // namespace check
