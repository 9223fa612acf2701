#pragma once
// The project file as tables. The attributes of <require>, and those of <workplace> about rules,
// are in rules/binding/requirement_attributes.h.

#include "calc/base/element_table.h"

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace calc {

inline constexpr std::size_t kCornerLimit = 2000;
inline constexpr std::size_t kZoneCornerLimit = 100;
inline constexpr std::size_t kRouteCornerLimit = 200;
inline constexpr std::size_t kMostTags = 32;

inline constexpr double kYear_h = 8760.0;
inline constexpr NumberRange kHours{0.0, kYear_h, false,
                                    "a number from 0 to 8760 (hours in a year)"};
inline constexpr double kFullTurn_deg = 360.0;
inline constexpr NumberRange kTurn{-kFullTurn_deg, kFullTurn_deg, false,
                                   "a number from -360 to 360 (degrees)"};

inline constexpr NumberRange kTilt{-90.0, 90.0, false, "a number from -90 to 90 (degrees)"};
inline constexpr NumberRange kLean{0.0, 80.0, false, "a number from 0 to 80 (degrees)"};
inline constexpr NumberRange kQ0{0.01, 0.5, false, "a number from 0.01 to 0.5"};

// An attribute of workplaces, but not of copies, each of which has an area.
inline constexpr std::string_view kTaskPlaceName = "task-place";

// Types that other folders use, too: choices, and values of requirements' attributes.
extern const ValueType kIdType, kTextType, kDecimalType, kNonNegativeType, kPositiveFractionType,
    kVectorType;
extern const ValueType kVersionType, kUnitsType, kHousingDimensionsType, kOpeningType,
    kInterpolationType, kUpAxisType, kLineEndsType, kRingTurnType, kPlaneQuantityType,
    kGlareMethodType, kTaskPlaceType, kTrafficSideType, kRoadSideType, kRoadSurfaceType,
    kStreetPlaneType;
// The type of a last day, YYYY-MM-DD.
extern const ValueType kDayType;
// Attributes of a waiver, see waiver_attributes.h.
extern const AttributeRow kBecauseAttribute, kByAttribute, kUntilAttribute;

// Attributes of a surface that emits light, besides luminous-exitance.
extern const std::vector<AttributeRow> kLuminousAttributes;

extern const std::string_view kProjectMeaning;
extern const ChildRow kProjectRoot;
extern const ElementRow kProjectElement;
extern const ElementRow kMaterialElement, kHousingElement, kLuminaireTypeElement, kSceneElement,
    kDimElement;
// Names of elements with project data, see scene/about_project.h.
inline constexpr std::string_view kAboutName = "about";
inline constexpr std::string_view kMaintenancePlanName = "maintenance-plan";
extern const ElementRow kAboutElement;
extern const ElementRow kMaintenancePlanElement;
extern const ElementRow kEnergyElement, kEnergyPartElement;
extern const ElementRow kBuildingElement;

// A luminaire type's package element, and the attribute that selects a package by its article.
inline constexpr std::string_view kPackageName = "package", kArticleName = "article";
extern const ElementRow kPackageElement;
// Attributes of the type that the package replaces.
inline constexpr std::array<std::string_view, 2> kReplacedByPackage{"flux-lm", "power-w"};

// All objects that a room, the open space or an assembly may contain.
extern const ElementGroup kObjects;
extern const ElementRow kBoxElement, kQuadElement, kPolygonElement, kMeshElement, kMapElement,
    kAssemblyElement;
extern const ElementRow kLuminaireElement, kLuminaireGridElement, kLuminaireLineElement,
    kLuminaireRingElement, kLuminaireListElement;

// The value of "shell" of a room from a mesh that is the space between all surfaces. The forms of a
// room follow; the schema has a single one for all.
inline constexpr std::string_view kAllShells = "all";
extern const ElementRow kPrismRoomElement, kGbxmlRoomElement, kMeshRoomElement;
extern const ElementRow kRoadElement, kLuminaireRowElement, kRoadStripElement;
extern const ElementRow kPlaneElement, kHoleElement, kRouteElement, kRequireElement;
extern const ElementRow kWorkplaceElement, kWorkplaceGridElement, kZoneElement, kWithoutElement;
// These lack their attributes: see rules/binding/deviation_xml.h and waiver_xml.h.
extern const ElementRow kDeviationElement, kWaiverElement;

}  // namespace calc
