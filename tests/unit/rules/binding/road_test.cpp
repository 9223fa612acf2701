// What is required of roads: by the project and by the classes of EN 13201-2, in a scene, of the
// right light, and of nothing but a road.
#include "calc/road/road_values.h"
#include "rules/applicability/applicability.h"
#include "rules/binding/judged_project.h"
#include "rules/pack/rule_pack.h"
#include "tests/support/memory_file_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rules::road_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

// Wide to both sides of the road and across it.
const std::string kHead =
    "IESNA:LM-63-2002\n[TEST] none\n[TESTLAB] none\n[ISSUEDATE] 2024\n[MANUFAC] none\nTILT=NONE\n"
    "1 -1 1 5 3 1 2 0.2 0.2 0\n1 1 80\n0 30 60 75 90\n0 90 180\n"
    "2000 2500 3000 500 0\n2000 2800 4500 1500 0\n2000 900 200 50 0\n";

struct Bound {
  calc::Project project;
  std::vector<Requirement> requirements;
  std::vector<std::string> messages;

  const Requirement& by(const std::string& id) const {
    for (const Requirement& requirement : requirements) {
      if (requirement.id == id || requirement.origin.check == id) return requirement;
    }
    throw std::logic_error("no requirement " + id);
  }
};

struct RoadText {
  std::string inside;
  std::string road = "";                                 // attributes
  std::string maintenance = "maintenance-factor='0.8'";  // of the project
  std::string row = "";
  std::string surface = "R3";
};

Bound bind_road(const RoadText& text) {
  const std::string xml =
      "<luxgate version='1' " + text.maintenance +
      "><luminaire-type id='head' photometry='head.ies'/><scene id='night'><dim group='g' "
      "level='0.5'/></scene><scene id='off'><dim group='g' level='0'/></scene><road id='a' "
      "width='7' lanes='2' spacing='30' surface='" +
      text.surface + "' " + text.road +
      "><luminaire-row id='r' type='head' side='right' height='9' group='g' " + text.row + "/>" +
      text.inside +
      "</road><quad id='q' origin='0 0 0' u='1 0 0' v='0 1 0' material='m'/><material id='m' "
      "reflectance='0.5'/><luminaire id='l' type='head' position='0 0 3'/></luxgate>";
  calc::Diagnostics diagnostics;
  const calc::MemoryFileReader files({{"p.xml", xml}, {"head.ies", kHead}});
  Bound bound;
  auto judged = load_judged_project(files, "p.xml", builtin_rule_packs(), diagnostics);
  for (const auto& d : diagnostics.all()) bound.messages.push_back(format_diagnostic(d));
  if (!judged) return bound;
  bound.requirements = std::move(judged->requirements);
  bound.project = std::move(judged->project);
  return bound;
}

const std::string kAll =
    "<require quantity='road-luminance' at-least='1'/><require quantity='road-Uo' at-least='0.4'/>"
    "<require quantity='road-Ul' at-least='0.6'/><require quantity='TI' at-most='15'/>"
    "<require quantity='REI' at-least='0.3'/>";

TEST(RoadRequirements, HaveTheValuesOfTheRoad) {
  const Bound bound = bind_road({kAll});
  EXPECT_THAT(bound.messages, IsEmpty());
  ASSERT_EQ(bound.requirements.size(), 5u);
  const calc::RoadValues values =
      calc::road_values(bound.project, bound.project.spaces.at(0), nullptr);
  EXPECT_GT(values.luminance_cd_m2.value.value, 0.1);
  EXPECT_EQ(bound.by("road-luminance").of_space.value, values.luminance_cd_m2.value.value);
  EXPECT_EQ(bound.by("road-Uo").of_space.value, values.uo.value.value);
  EXPECT_EQ(bound.by("road-Ul").of_space.value, values.ul.value.value);
  EXPECT_EQ(bound.by("TI").of_space.value, values.ti_percent.value.value);
  EXPECT_EQ(bound.by("REI").of_space.value, values.rei.value.value);
  EXPECT_LT(bound.by("road-luminance").of_space.low, values.luminance_cd_m2.value.high);
  EXPECT_STREQ(unit_of(bound.by("road-luminance")), "cd/m2");
  EXPECT_STREQ(unit_of(bound.by("TI")), "%");
  EXPECT_STREQ(unit_of(bound.by("REI")), "");
  EXPECT_EQ(bound.by("TI").state, LightState::initial);
  EXPECT_EQ(bound.by("road-luminance").state, LightState::maintained);
  EXPECT_THAT(bound.by("road-Uo").note.english(),
              AllOf(HasSubstr("lanes from the right: "), HasSubstr("by EN 13201-3")));
  EXPECT_THAT(bound.by("REI").note.english(), HasSubstr("right and left edge: "));
}

// The worst lane and the darker edge count, by both ends of their intervals.
TEST(RoadRequirements, AreOfTheWorst) {
  const Bound bound = bind_road({kAll});
  const calc::Space& space = bound.project.spaces.at(0);
  const calc::RoadLight light = calc::road_light(calc::road_layout(bound.project, space, nullptr));
  ASSERT_EQ(light.observers.size(), 2u);
  for (const calc::RoadObserver& observer : light.observers) {
    EXPECT_LE(bound.by("road-luminance").of_space.value, observer.average_cd_m2.value);
    EXPECT_LE(bound.by("road-luminance").of_space.low, observer.average_cd_m2.low);
    EXPECT_LE(bound.by("road-Uo").of_space.high, observer.uo->high);
    EXPECT_LE(bound.by("road-Ul").of_space.value, observer.ul->value);
    EXPECT_GE(bound.by("TI").of_space.high, observer.ti_percent->high);
    EXPECT_GE(bound.by("TI").of_space.value, observer.ti_percent->value);
  }
  EXPECT_EQ(bound.by("REI").of_space.value,
            std::min(light.right_ratio->value, light.left_ratio->value));
  EXPECT_NE(light.right_ratio->value, light.left_ratio->value);
  EXPECT_NE(light.observers[0].ti_percent->value, light.observers[1].ti_percent->value);
}

// L grows with the light, ratios stay, and TI grows with its fifth root; maintenance counts for L
// alone.
TEST(RoadRequirements, FollowScenesAndMaintenance) {
  const auto both = [](const std::string& quantity, const std::string& limit) {
    return "<require id='all' quantity='" + quantity + "' " + limit +
           "/><require id='dim' quantity='" + quantity + "' scene='night' " + limit + "/>";
  };
  const Bound l = bind_road({both("road-luminance", "at-least='1'")});
  EXPECT_NEAR(l.by("dim").of_space.value, 0.5 * l.by("all").of_space.value, 1e-12);
  const Bound uo = bind_road({both("road-Uo", "at-least='0.4'")});
  EXPECT_NEAR(uo.by("dim").of_space.value, uo.by("all").of_space.value, 1e-12);
  const Bound ti = bind_road({both("TI", "at-most='15'")});
  EXPECT_NEAR(ti.by("dim").of_space.value, ti.by("all").of_space.value * std::pow(0.5, 0.2), 1e-9);
  const Bound old = bind_road({kAll, "", "maintenance-factor='0.4'"});
  EXPECT_NEAR(old.by("road-luminance").of_space.value, 0.5 * l.by("all").of_space.value, 1e-12);
  EXPECT_NEAR(old.by("TI").of_space.value, ti.by("all").of_space.value, 1e-12);
}

TEST(RoadRequirements, OfDarknessAreNotJudged) {
  const Bound bound = bind_road(
      {"<require quantity='road-luminance' scene='off' at-least='1'/><require quantity='road-Uo' "
       "scene='off' at-least='0.4'/><require quantity='TI' scene='off' at-most='15'/><require "
       "quantity='REI' scene='off' at-least='0.3'/>"});
  ASSERT_EQ(bound.requirements.size(), 4u);
  EXPECT_EQ(bound.by("road-luminance").problem, "");
  EXPECT_EQ(bound.by("road-luminance").of_space.high, 0.0);
  EXPECT_EQ(bound.by("road-Uo").problem, "no light falls on a part of the road");
  EXPECT_EQ(bound.by("TI").problem, "TI is defined only for a mean luminance above 0.05 cd/m²");
  EXPECT_EQ(bound.by("REI").problem, "no light falls on a part of the road");
}

TEST(RoadRequirements, OfEdgesNeedStrips) {
  const std::string rei = "<require quantity='REI' at-least='0.3'/>";
  const Bound both = bind_road({rei});
  const Bound right = bind_road({rei, "left-strip='0'"});
  const Bound left = bind_road({rei, "right-strip='0'"});
  const Bound none = bind_road({rei, "right-strip='0' left-strip='0'"});
  EXPECT_EQ(both.by("REI").of_space.value,
            std::min(right.by("REI").of_space.value, left.by("REI").of_space.value));
  EXPECT_THAT(right.by("REI").note.english(), HasSubstr("one edge only"));
  EXPECT_EQ(right.by("REI").problem, "");
  EXPECT_EQ(none.by("REI").problem, "no strip beside the road counts");
  EXPECT_THAT(none.by("REI").note.english(), Not(HasSubstr("one edge only")));
}

TEST(RoadRequirements, OfClassesNameTheirChecks) {
  const Bound bound = bind_road(
      {"<require pack='en13201-2' row='M3'/><strip id='w' side='right' width='2'><require "
       "pack='en13201-2' row='P3'/></strip>"});
  EXPECT_THAT(bound.messages, IsEmpty());
  std::vector<std::string> checks;
  for (const Requirement& requirement : bound.requirements) {
    checks.push_back(requirement.plane_id + " " + requirement.origin.check);
  }
  EXPECT_THAT(checks, ElementsAre("a M.luminance", "a M.uniformity", "a M.lengthwise", "a M.glare",
                                  "a M.edges", "w P.average", "w P.minimum", "w P.not-too-much"));
  EXPECT_EQ(bound.by("M.luminance").limit, 1.0);
  EXPECT_EQ(bound.by("M.lengthwise").limit, 0.6);
  EXPECT_EQ(bound.by("M.glare").limit, 15.0);
  EXPECT_EQ(bound.by("M.glare").comparison, Comparison::at_most);
  EXPECT_EQ(bound.by("M.glare").state, LightState::initial);
  EXPECT_EQ(bound.by("M.edges").metric, Metric::edge_ratio);
  // An illuminance class is of the same carriageway, without a role.
  const Bound conflict = bind_road({"<require pack='en13201-2' row='C3'/>"});
  EXPECT_THAT(conflict.messages, IsEmpty());
  EXPECT_EQ(conflict.by("C.average").metric, Metric::average);
}

TEST(RoadRequirements, AreOfCarriagewaysOnly) {
  const Bound own =
      bind_road({"<strip id='w' side='right' width='2'><require "
                 "quantity='TI' at-most='15'/></strip>"});
  EXPECT_THAT(own.messages,
              ElementsAre(HasSubstr("error[quantity-of-road]: <require>: 'TI' is about the "
                                    "carriageway of a <road>, and this plane is not one")));
  const Bound row =
      bind_road({"<strip id='w' side='right' width='2'><require pack='en13201-2' "
                 "row='M3' role='carriageway'/></strip>"});
  EXPECT_THAT(row.messages, ElementsAre(HasSubstr("error[quantity-of-road]")));
}

// What the road is belongs to the question: a comparison of results has it.
TEST(RoadRequirements, SayWhatTheRoadIs) {
  const std::string l = "<require quantity='road-luminance' at-least='1'/>";
  EXPECT_EQ(bind_road({l}).requirements.at(0).stated_words,
            "surface R3 with Q0 = 0.07, 7 m wide, lanes from the right ++, counted strips 3.5 m "
            "and 3.5 m");
  EXPECT_EQ(
      bind_road({l, "oncoming-lanes='1' q0='0.08' left-strip='0'"}).requirements.at(0).stated_words,
      "surface R3 with Q0 = 0.08, 7 m wide, lanes from the right +-, counted strips 3.5 m and 0 m");
}

// An assumption that turns everything is with every value.
TEST(RoadRequirements, SayThatTheStreetIsAssumed) {
  EXPECT_THAT(bind_road({kAll}).by("TI").note.english(),
              HasSubstr("the street side of a photometry is assumed"));
  RoadText text{kAll};
  text.row = "street='C90'";
  EXPECT_THAT(bind_road(text).by("TI").note.english(), Not(HasSubstr("the street side")));
}

// M classes are of dry surfaces; a limit of the project's own may be of a wet one.
TEST(RoadRequirements, OfRowsAreOfDrySurfaces) {
  RoadText text{
      "<require pack='en13201-2' row='M3'/><require quantity='road-Uo' "
      "at-least='0.15'/>"};
  text.surface = "W3";
  const Bound bound = bind_road(text);
  ASSERT_EQ(bound.requirements.size(), 6u);
  for (const Requirement& requirement : bound.requirements) {
    const std::string wanted =
        requirement.origin.pack.empty() ? "" : "the row is for dry surfaces; W3 is wet";
    EXPECT_EQ(requirement.problem, wanted) << requirement.origin.check;
  }
  EXPECT_THAT(calc::texts(bound.project.spaces.at(0).notes),
              Contains(HasSubstr("the surface is wet")));
}

// An emitter beside the middle of its luminaire, behind the beginning of the field.
TEST(RoadRequirements, KnowEmittersBehindTheField) {
  Bound bound = bind_road({kAll});
  calc::Space& space = bound.project.spaces.at(0);
  space.road->rows.at(0).position_m.x = -0.25;
  const calc::RoadLayout layout = calc::road_layout(bound.project, space, nullptr);
  EXPECT_DOUBLE_EQ(layout.rows.at(0).shift_m, 29.75);
  EXPECT_EQ(calc::road_values(bound.project, space, nullptr).uo.problem, "");
}

TEST(RoadRequirements, TakeNoOtherAttributes) {
  for (const std::string unfit :
       {"state='initial'", "light='direct'", "unit='lx'", "percent='5'"}) {
    const Bound bound =
        bind_road({"<require quantity='road-luminance' at-least='1' " + unfit + "/>"});
    EXPECT_THAT(bound.messages, ElementsAre(HasSubstr("error"))) << unfit;
  }
  EXPECT_THAT(bind_road({"<require quantity='road-Uo' at-least='1.1'/>"}).messages,
              ElementsAre(HasSubstr("a ratio from 0 to 1")));
}

// Own limits are compared with light that never fades, and somebody must know.
TEST(RoadRequirements, WantMaintenance) {
  EXPECT_THAT(bind_road({"<require quantity='road-luminance' at-least='1'/>", "", ""}).messages,
              ElementsAre(HasSubstr("maintenance")));
  EXPECT_THAT(bind_road({"<require quantity='TI' at-most='15'/>", "", ""}).messages, IsEmpty());
}

}  // namespace
}  // namespace rules::road_test
