#include "report/document/luminaire_labels.h"

#include "report/document/luminaire_schedule.h"
#include "report/document/storeys.h"
#include "report/html/chapters/html_storeys.h"
#include "report/html/drawings/plan_layout.h"
#include "report/result_file/read_json.h"
#include "tests/support/rendered.h"
#include "tests/support/sample_document.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace report::luminaire_labels_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

SpacePart room(const std::string& name, double x, double z = 0.0) {
  SpacePart space = small_document().projects[0].spaces[0];
  space.id = "id-" + name;
  space.name = name;
  space.footprint_m = {{x, 0}, {x + 6, 0}, {x + 6, 5}, {x, 5}};
  space.floor_z_m = z;
  space.planes[0].id = space.id + ".work";
  for (rules::Finding& finding : space.planes[0].findings)
    finding.requirement.plane_id = space.planes[0].id;
  space.luminaires = {{{x + 3, 4, z + 2.7}, "spot"}, {{x + 1.5, 1, z + 2.7}, "panel"}};
  return space;
}

// Described from above to below; a road and a type of which nobody has the description.
Document house() {
  Document document = small_document();
  ProjectPart& project = document.projects[0];
  project.luminaires.resize(3);
  const char* ids[] = {"panel", "idle", "spot"};
  for (std::size_t i = 0; i < 3; ++i) project.luminaires[i].type_id = ids[i];
  project.luminaires[0].count = project.luminaires[2].count = 4;
  SpacePart road = room("A road", 0);
  road.footprint_m.clear();
  road.luminaires[1].type_id = "unknown";
  project.spaces = {road, room("Room 20", 0, 3.0), room("Room 10", 7), room("Room 9", 0)};
  label_luminaires(project);
  return document;
}

std::vector<std::string> labels(const ProjectPart& project, const std::string& room) {
  std::vector<std::string> found;
  for (const SpacePart& space : project.spaces) {
    if (space.name != room) continue;
    for (const LuminaireMark& mark : space.luminaires) found.push_back(mark.label);
  }
  return found;
}

std::vector<std::string> all_labels(const ProjectPart& project) {
  std::vector<std::string> found;
  for (const SpacePart& space : project.spaces) {
    for (const LuminaireMark& mark : space.luminaires) found.push_back(mark.label);
  }
  return found;
}

TEST(LuminaireLabels, CountByStoreysAndNamesOfRooms) {
  const Document document = house();
  const ProjectPart& project = document.projects[0];
  EXPECT_THAT(labels(project, "Room 9"), ElementsAre("C1", "A1"));
  EXPECT_THAT(labels(project, "Room 10"), ElementsAre("C2", "A2"));
  EXPECT_THAT(labels(project, "Room 20"), ElementsAre("C3", "A3"));
  EXPECT_THAT(labels(project, "A road"), ElementsAre("C4", "1")) << "of an unknown type: a number";
}

TEST(LuminaireLabels, AreUnique) {
  Document document = house();
  ProjectPart& project = document.projects[0];
  project.spaces[0].name = std::string(20'000, 'x');
  project.spaces[1].name = project.spaces[2].name = "Office";
  project.spaces[3].name.clear();
  project.spaces[0].luminaires.resize(500, project.spaces[0].luminaires[0]);
  label_luminaires(project);
  const std::vector<std::string> found = all_labels(project);
  EXPECT_EQ(std::set<std::string>(found.begin(), found.end()).size(), found.size());
  EXPECT_EQ(found.size(), 506u);
}

TEST(LuminaireLabels, DoNotDependOnTheOrderOfPlanesAndRooms) {
  Document document = house();
  ProjectPart& project = document.projects[0];
  for (SpacePart& space : project.spaces) {
    PlanePart second = space.planes[0];
    second.id += "2";
    space.planes.insert(space.planes.begin(), second);
  }
  std::reverse(project.spaces.begin(), project.spaces.end());
  label_luminaires(project);
  EXPECT_THAT(labels(project, "Room 9"), ElementsAre("C1", "A1"));
  EXPECT_THAT(labels(project, "Room 20"), ElementsAre("C3", "A3"));
}

TEST(LuminaireLabels, AreTheSameAfterReadingAResultWhichDoesNotHoldThem) {
  Document document = sample_document();
  document.projects[0].spaces[1].luminaires[3].type_id = "panel";
  label_luminaires(document.projects[0]);
  const std::string json = rendered("json", document);
  EXPECT_THAT(json, testing::Not(HasSubstr("\"label\"")));
  std::string problem;
  const std::optional<Document> read = read_json(json, problem);
  ASSERT_TRUE(read) << problem;
  EXPECT_EQ(all_labels(read->projects[0]), all_labels(document.projects[0]));
}

TEST(LuminaireLabels, AreThoseOfScheduleAndPlansAndTables) {
  const Document document = house();
  const ProjectPart& project = document.projects[0];
  for (const ScheduleRow& row : schedule_of(project).used) {
    for (const SpacePart* space : row.spaces) {
      for (const LuminaireMark& mark : space->luminaires) {
        if (mark.type_id != row.type->type_id) continue;
        EXPECT_THAT(mark.label, StartsWith(row.position));
      }
    }
  }
  const std::string plans = html_storeys({}, project, 0, Paper::a4);
  for (const char* label : {">A1<", ">C2<", ">A3<"}) EXPECT_THAT(plans, HasSubstr(label));
  const SpacePart& last = project.spaces[3];
  const PlanLayout layout = lay_out_plan(last, last.planes[0], {640, 460});
  ASSERT_FALSE(layout.luminaires_m.empty());
  for (const PlanLuminaire& sign : layout.luminaires_m)
    EXPECT_THAT(labels(project, "Room 9"), testing::Contains(sign.label));
  const std::string csv = rendered("luminaires-csv", document);
  for (const std::string& label : all_labels(project))
    EXPECT_THAT(csv, HasSubstr("," + label + "\r\n"));
  const std::string dxf = rendered("dxf", document);
  for (const std::string& label : all_labels(project))
    EXPECT_THAT(dxf, HasSubstr("\n" + label)) << label;
}

TEST(SpacesInOrder, OfEqualNamesIdsDecide) {
  Document document = house();
  ProjectPart& project = document.projects[0];
  for (SpacePart& space : project.spaces) {
    space.footprint_m.clear();
    space.name = "Yard";
  }
  const char* ids[] = {"y10", "y9", "y1", "y2"};
  for (std::size_t i = 0; i < 4; ++i) project.spaces[i].id = ids[i];
  EXPECT_THAT(spaces_in_order(project), ElementsAre(2u, 3u, 1u, 0u));
}

}  // namespace
}  // namespace report::luminaire_labels_test
