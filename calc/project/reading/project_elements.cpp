#include "calc/project/reading/project_elements.h"

#include "calc/base/names.h"
#include "calc/base/text_lengths.h"
#include "calc/base/units.h"
#include "calc/meshes/triangle_mesh.h"
#include "calc/road/r_table.h"
#include "calc/scene/project.h"
#include "calc/scene/receiver_kernel.h"

#include <limits>

namespace calc {
namespace {

using enum Presence;

constexpr std::string_view kIdPattern = R"([A-Za-z0-9_.:\-]+)";
constexpr NumberRange kFromNone{0.0, std::numeric_limits<double>::infinity(), false, ""};
constexpr NumberRange kFromOne{1.0, std::numeric_limits<double>::infinity(), false, ""};

Names unit_names() {
  Names names;
  for (const LengthUnit& unit : kLengthUnits) names.push_back(unit.name);
  return names;
}

Names plane_quantity_names() {
  Names names;
  for (const PlaneQuantity& quantity : kPlaneQuantities) names.push_back(quantity.name);
  return names;
}

}  // namespace

// Texts.
const ValueType kIdType{.name = "id",
                        .base = &kAnyText,
                        .meaning = "Letters A-Z and a-z, digits and _ . : -",
                        .pattern = kIdPattern,
                        .most = kLongestId};
const ValueType kTextType{.name = "text",
                          .base = &kAnyText,
                          .meaning = "Not empty, not only blanks.",
                          .pattern = R"(.*\S.*)",
                          .most = kLongestText};
const ValueType kVersionType{.name = "version", .base = &kAnyText, .words = {"1"}};
const ValueType kUnitsType{.name = "units", .base = &kAnyText, .words = unit_names()};
const ValueType kHousingDimensionsType{
    .name = "housingDimensions", .base = &kAnyText, .words = {"file"}};
const ValueType kOpeningType{.name = "opening", .base = &kAnyText, .words = {"file", "point"}};
const ValueType kInterpolationType{
    .name = "interpolation", .base = &kAnyText, .words = {"linear", "cubic"}};
const ValueType kUpAxisType{.name = "upAxis", .base = &kAnyText, .words = {"z", "y"}};
const ValueType kLineEndsType{.name = "lineEnds", .base = &kAnyText, .words = {"half", "end"}};
const ValueType kRingTurnType{.name = "ringTurn", .base = &kAnyText, .words = {"yes", "no"}};
const ValueType kGlareMethodType{
    .name = "glareMethod", .base = &kAnyText, .words = {"table", "observers"}};
const ValueType kTaskPlaceType{.name = "taskPlace", .base = &kAnyText, .words = {"unknown"}};
// Which side people drive on.
const ValueType kTrafficSideType{
    .name = "trafficSide", .base = &kAnyText, .words = {"right", "left"}};
const ValueType kRoadSideType{.name = "roadSide", .base = &kAnyText, .words = {"right", "left"}};
const ValueType kRoadSurfaceType{
    .name = "roadSurface", .base = &kAnyText, .words = r_table_names()};
const ValueType kStreetPlaneType{
    .name = "streetPlane", .base = &kAnyText, .words = {"C0", "C90", "C180", "C270"}};
const ValueType kPlaneQuantityType{
    .name = "planeQuantity", .base = &kAnyText, .words = plane_quantity_names()};

// Of waivers.
const ValueType kDayType{.name = "day", .base = &kAnyDate, .pattern = "[0-9]{4}-[0-9]{2}-[0-9]{2}"};
const AttributeRow kBecauseAttribute{"because", &kTextType, required, "Why."};
const AttributeRow kByAttribute{"by", &kTextType, required, "Who has agreed to it."};
const AttributeRow kUntilAttribute{"until", &kDayType, required,
                                   "The last day, YYYY-MM-DD. It does not apply after that day."};

// Numbers.
const ValueType kDecimalType{.name = "decimal",
                             .base = &kAnyDouble,
                             .meaning = "A finite number: 2, -0.5, 1e-3.",
                             .pattern = R"([+\-]?([0-9]+(\.[0-9]*)?|\.[0-9]+)([eE][+\-]?[0-9]+)?)"};
const ValueType kNonNegativeType{
    .name = "nonNegative", .base = &kDecimalType, .range = kNonNegative};

const ValueType kPositiveFractionType{.name = "positiveFraction",
                                      .base = &kDecimalType,
                                      .meaning = "Above 0, up to 1.",
                                      .range = kPositiveFraction};

namespace {

const ValueType kNumberType{.name = "number",
                            .base = &kDecimalType,
                            .meaning = "Coordinates, directions, angles.",
                            .range = kCoordinate};
const ValueType kPositiveType{.name = "positive", .base = &kDecimalType, .range = kPositive};
const ValueType kFractionType{
    .name = "fraction", .base = &kDecimalType, .meaning = "From 0 to 1.", .range = kFraction};
const ValueType kTurnType{
    .name = "turn", .base = &kDecimalType, .meaning = "Degrees from -360 to 360.", .range = kTurn};
const ValueType kTiltType{
    .name = "tilt", .base = &kDecimalType, .meaning = "Degrees from -90 to 90.", .range = kTilt};
const ValueType kQ0Type{.name = "luminanceCoefficient", .base = &kDecimalType, .range = kQ0};
const ValueType kHoursType{.name = "hoursOfYear", .base = &kDecimalType, .range = kHours};
const ValueType kCountType{
    .name = "count", .base = &kAnyInt, .meaning = "A whole number from 1.", .range = kFromOne};
const ValueType kCountOrNoneType{.name = "countOrNone",
                                 .base = &kAnyInt,
                                 .meaning = "A whole number from 0.",
                                 .range = kFromNone};

}  // namespace

// Lists.
const ValueType kVectorType{
    .name = "vector", .meaning = "x y z", .item = &kNumberType, .least = 3, .most = 3};

namespace {

const ValueType kIdsType{
    .name = "ids", .meaning = "Ids separated by blanks.", .item = &kIdType, .least = 3};
const ValueType kSizeType{.name = "size",
                          .meaning = "x y z, each above 0",
                          .item = &kPositiveType,
                          .least = 3,
                          .most = 3};
const ValueType kVector2Type{
    .name = "vector2", .meaning = "x y", .item = &kNumberType, .least = 2, .most = 2};
const ValueType kFootType{
    .name = "foot", .meaning = "x y x y", .item = &kNumberType, .least = 4, .most = 4};
const ValueType kFromToType{.name = "fromTo",
                            .meaning = "Two ascending numbers from 0.",
                            .item = &kNonNegativeType,
                            .least = 2,
                            .most = 2};
const ValueType kLeanType{.name = "lean", .base = &kAnyDouble, .range = kLean};
const ValueType kSize2Type{
    .name = "size2", .meaning = "x y, each above 0", .item = &kPositiveType, .least = 2, .most = 2};
const ValueType kCounts3Type{.name = "counts3", .item = &kCountType, .least = 3, .most = 3};
const ValueType kCounts2Type{.name = "counts2", .item = &kCountType, .least = 2, .most = 2};
const ValueType kSpacingsType{
    .name = "spacings",
    .meaning = "One distance for both directions, or one along u and one along v.",
    .item = &kPositiveType,
    .least = 1,
    .most = 2};
const ValueType kFootprintType{
    .name = "footprint",
    .meaning = "3 to 2000 corners x y, in order around the room, the first one not repeated.",
    .pattern = "[^ ]+ [^ ]+( [^ ]+ [^ ]+)*",
    .item = &kNumberType,
    .least = 2 * 3,
    .most = 2 * kCornerLimit};
const ValueType kZoneFootprintType{
    .name = "zoneFootprint", .base = &kFootprintType, .most = 2 * kZoneCornerLimit};
const ValueType kCornersType{
    .name = "corners",
    .meaning = "3 to 2000 corners x y z in one plane, in order, the first one not repeated.",
    .pattern = "[^ ]+ [^ ]+ [^ ]+( [^ ]+ [^ ]+ [^ ]+)*",
    .item = &kNumberType,
    .least = 3 * 3,
    .most = 3 * kCornerLimit};
const ValueType kRouteLineType{.name = "routeLine",
                               .meaning = "2 to 200 corners x y z, in order.",
                               .pattern = "[^ ]+ [^ ]+ [^ ]+( [^ ]+ [^ ]+ [^ ]+)*",
                               .item = &kNumberType,
                               .least = 3 * 2,
                               .most = 3 * kRouteCornerLimit};

// Of single attributes.
const ValueType kMeshFormatType{
    .name = "meshFormat", .base = &kAnyText, .words = names_of<MeshFormat>()};
const ValueType kMeshShellType{
    .name = "meshShell", .base = &kAnyText, .pattern = R"(all|[1-9][0-9]{0,7})"};
const ValueType kGridRoundingType{
    .name = "gridRounding", .base = &kAnyText, .words = names_of<GridRounding>()};
const ValueType kRoomSurfaceType{
    .name = "roomSurface", .base = &kAnyText, .pattern = "floor|ceiling|wall[1-9][0-9]{0,3}"};
const ValueType kBoxNameType{
    .name = "boxName", .base = &kAnyText, .pattern = R"([A-Za-z0-9_.:\-\[\],]+)"};
const ValueType kRoomIdType{
    .name = "roomId",
    .base = &kIdType,
    .meaning = "Not \"site\", which is the open space.",
    .pattern = R"(([A-Za-z0-9_.:\-]{1,3}|[^s][A-Za-z0-9_.:\-]{3}|s[^i][A-Za-z0-9_.:\-]{2})"
               R"(|si[^t][A-Za-z0-9_.:\-]|sit[^e]|[A-Za-z0-9_.:\-]{5,}))"};

// Attributes that several elements have.
const AttributeRow kIdAttribute{"id", &kIdType, required};
const AttributeRow kNameAttribute{"name", &kAnyText};
const AttributeRow kWasAttribute{
    "was", &kIdType, optional,
    "The id in earlier revisions. Comparisons use it to find renamed objects."};
const ValueType kTagsType{.name = "tags",
                          .meaning = "Words like ids, separated by blanks.",
                          .item = &kIdType,
                          .least = 1,
                          .most = kMostTags};
const AttributeRow kTagsAttribute{"tags", &kTagsType, optional,
                                  "Your own words for 'luxgate check --tag'. The tag of a room "
                                  "selects all of its planes. Tags change no result."};
const AttributeRow kFileAttribute{"file", &kTextType, required};
const AttributeRow kMaterialAttribute{"material", &kIdType, required};
const AttributeRow kMaterialOfOthersAttribute{"material", &kIdType, optional,
                                              "For all surfaces that no map names."};
const AttributeRow kOccupancyAttribute{"occupancy", &kPositiveFractionType, optional,
                                       "Fo of EN 15193; 1."};
const AttributeRow kDaylightAttribute{"daylight", &kPositiveFractionType, optional,
                                      "FD of EN 15193; 1."};
const AttributeRow kConstantIlluminanceAttribute{"constant-illuminance", &kPositiveFractionType,
                                                 optional, "Fc of EN 15193; 1."};
const AttributeRow kPositionAttribute{"position", &kVectorType, optional,
                                      "Where the object's origin goes (0 0 0)."};
const AttributeRow kRotationAttribute{"rotation", &kNumberType, optional,
                                      "About the vertical axis through the object's origin."};
const AttributeRow kRepeatAttribute{
    "repeat", &kCounts3Type, optional,
    "Numbers of copies along x, y and z of the surrounding coordinates, with step. Copies are "
    "named id[i,j,k], counted from 0."};
const AttributeRow kStepAttribute{"step", &kVectorType, optional,
                                  "Distances of the copies, with repeat."};
const AttributeRow kMeshFormatAttribute{"format", &kMeshFormatType, optional,
                                        "The contents of the file decide the format. With this "
                                        "attribute any other format is an error."};
const AttributeRow kMeshNodeAttribute{
    "node", &kTextType, optional,
    "Reads only the node of this name in a glTF file, and all nodes below it, such as a storey."};
const AttributeRow kMeshScaleAttribute{"scale", &kPositiveType, optional,
                                       "Factor besides the units.", "1"};
const AttributeRow kMeshUpAttribute{"up", &kUpAxisType, optional, "The file's vertical axis."};
const AttributeRow kMeshUnitsAttribute{"units", &kUnitsType, optional, "Of the file."};
const AttributeRow kTypeAttribute{"type", &kIdType, required};
const AttributeRow kAxisAttribute{"axis", &kVectorType, optional,
                                  "Direction of gamma = 0 (0 0 -1, straight down)."};
const AttributeRow kC0RotationAttribute{
    "rotation", &kNumberType, optional,
    "Angle of C0, from the x axis counter-clockwise, for a luminaire that shines straight down. "
    "The smallest rotation from there gives other axes (straight up: half a turn about x)."};
const AttributeRow kC0Attribute{
    "c0", &kVectorType, optional,
    "The direction of C0, instead of rotation. Only its part across the axis counts."};
const AttributeRow kGroupAttribute{"group", &kTextType, optional, "Dimming group."};
const AttributeRow kGroupNamedAttribute{"group", &kTextType, required};
const AttributeRow kCountAttribute{"count", &kCounts2Type, optional, "Points along u and v."};
const AttributeRow kSpacingAttribute{"spacing", &kSpacingsType, optional,
                                     "Distances of the points, whose numbers are rounded up."};
const AttributeRow kRoundingAttribute{
    "rounding", &kGridRoundingType, optional,
    "How the rule's numbers of points are rounded; to the nearest if not given."};
const AttributeRow kZoneOriginAttribute{"origin", &kVector2Type};
const AttributeRow kZoneSizeAttribute{"size", &kSize2Type};
const AttributeRow kZoneFootprintAttribute{"footprint", &kZoneFootprintType};
const AttributeRow kHeightAboveFloorAttribute{"height", &kNonNegativeType, optional,
                                              "Above the floor."};

constexpr std::string_view kOfRoot =
    R"(<!-- Ids are unique within their kind; parts of assemblies within the assembly, objects within their room. -->
<xs:key name="materialId"><xs:selector xpath="material"/><xs:field xpath="@id"/></xs:key>
<xs:key name="luminaireTypeId"><xs:selector xpath="luminaire-type"/><xs:field xpath="@id"/></xs:key>
<xs:key name="sceneId"><xs:selector xpath="scene"/><xs:field xpath="@id"/></xs:key>
<xs:key name="roomId"><xs:selector xpath="room|road"/><xs:field xpath="@id"/></xs:key>
<xs:unique name="buildingId"><xs:selector xpath="building"/><xs:field xpath="@id"/></xs:unique>
<xs:key name="planeId"><xs:selector xpath=".//plane|.//route|road|road/strip"/><xs:field xpath="@id"/></xs:key>
<xs:unique name="openObjectId"><xs:selector xpath="box|quad|polygon|mesh|assembly"/><xs:field xpath="@id"/></xs:unique>
<xs:unique name="openLuminaireId"><xs:selector xpath="luminaire|luminaire-grid|luminaire-line|luminaire-ring|luminaires"/><xs:field xpath="@id"/></xs:unique>
<xs:keyref name="sceneOfRequirement" refer="sceneId"><xs:selector xpath=".//require|.//workplace"/><xs:field xpath="@scene"/></xs:keyref>
<xs:keyref name="objectMaterial" refer="materialId"><xs:selector xpath=".//box|.//quad|.//polygon|.//mesh|.//map"/><xs:field xpath="@material"/></xs:keyref>
<xs:keyref name="roomMaterial" refer="materialId"><xs:selector xpath="room"/><xs:field xpath="@material"/></xs:keyref>
<xs:keyref name="ceilingMaterial" refer="materialId"><xs:selector xpath="room"/><xs:field xpath="@ceiling"/></xs:keyref>
<xs:keyref name="wallMaterial" refer="materialId"><xs:selector xpath="room"/><xs:field xpath="@walls"/></xs:keyref>
<xs:keyref name="floorMaterial" refer="materialId"><xs:selector xpath="room"/><xs:field xpath="@floor"/></xs:keyref>
<xs:keyref name="typeOfLuminaire" refer="luminaireTypeId"><xs:selector xpath=".//luminaire|.//luminaire-grid|.//luminaire-line|.//luminaire-ring|road/luminaire-row"/><xs:field xpath="@type"/></xs:keyref>)";
constexpr std::string_view kOfLuminaireType =
    R"(<xs:key name="packageArticle"><xs:selector xpath="package"/><xs:field xpath="@article"/></xs:key>
<xs:keyref name="packageOfType" refer="packageArticle"><xs:selector xpath="."/><xs:field xpath="@package"/></xs:keyref>)";
constexpr std::string_view kOfScene =
    R"(<xs:unique name="dimmedGroup"><xs:selector xpath="dim"/><xs:field xpath="@group"/></xs:unique>)";
constexpr std::string_view kOfEnergy =
    R"(<xs:unique name="energyGroup"><xs:selector xpath="part"/><xs:field xpath="@group"/></xs:unique>)";
constexpr std::string_view kOfCommonEnergy =
    R"(<xs:unique name="energyGroupOfAll"><xs:selector xpath="part"/><xs:field xpath="@group"/></xs:unique>)";
constexpr std::string_view kOfMesh =
    R"(<xs:unique name="mapName"><xs:selector xpath="map"/><xs:field xpath="@name"/></xs:unique>)";
constexpr std::string_view kOfAssembly =
    R"(<xs:unique name="partId"><xs:selector xpath="box|quad|polygon|mesh|assembly"/><xs:field xpath="@id"/></xs:unique>
<xs:unique name="partLuminaireId"><xs:selector xpath="luminaire|luminaire-grid|luminaire-line|luminaire-ring|luminaires"/><xs:field xpath="@id"/></xs:unique>)";
constexpr std::string_view kOfWorkplace =
    R"(<xs:unique name="zoneRole"><xs:selector xpath="zone|without"/><xs:field xpath="@role"/></xs:unique>)";
constexpr std::string_view kOfWorkplaceGrid =
    R"(<xs:unique name="zoneRoleOfGrid"><xs:selector xpath="zone|without"/><xs:field xpath="@role"/></xs:unique>)";
constexpr std::string_view kOfRoad =
    R"(<xs:unique name="roadRowId"><xs:selector xpath="luminaire-row"/><xs:field xpath="@id"/></xs:unique>)";
constexpr std::string_view kOfRoom =
    R"(<xs:unique name="roomMapName"><xs:selector xpath="map"/><xs:field xpath="@name"/></xs:unique>
<xs:unique name="roomObjectId"><xs:selector xpath="box|quad|polygon|mesh|assembly"/><xs:field xpath="@id"/></xs:unique>
<xs:unique name="roomLuminaireId"><xs:selector xpath="luminaire|luminaire-grid|luminaire-line|luminaire-ring|luminaires"/><xs:field xpath="@id"/></xs:unique>)";

}  // namespace

const ElementRow kAboutElement{
    .type = "about",
    .meaning =
        "Client and author of the design, at most once. Reports show them on the first page. Light "
        "and verdicts do not depend on them.",
    .attributes = {
        {"client", &kAnyText},
        {"number", &kAnyText, optional, "Number of the project."},
        {"revision", &kAnyText, optional,
         "Revision of the design; --set about.revision=... can give it, such as a commit."},
        {"date", &kDayType, optional,
         "Date of the design, YYYY-MM-DD. It is never the current day by default."},
        {"author", &kAnyText},
        {"company", &kAnyText},
        {"address", &kAnyText},
        {"note", &kAnyText},
        {"logo", &kTextType, optional,
         "A PNG of at most 4096 pixels each way or an SVG without script, links and "
         "animation; at most 1 MiB."}}};

const ElementRow kMaintenancePlanElement{
    .type = "maintenancePlan",
    .meaning =
        "The conditions of the maintenance factors, at most once, for the maintenance plan in "
        "reports. Light and verdicts do not depend on them.",
    .attributes = {{"environment", &kAnyText, optional, "The surroundings, such as clean office."},
                   {"clean-luminaires-months", &kPositiveType, optional,
                    "Months between two cleanings of the luminaires."},
                   {"clean-surfaces-months", &kPositiveType, optional,
                    "Months between two cleanings of the room's surfaces."},
                   {"replace-lights-hours", &kPositiveType, optional,
                    "Hours of use after which light sources or luminaires are replaced."},
                   {"hours-in-a-year", &kHoursType, optional, "Hours of use in a year."},
                   {"instructions", &kAnyText, optional, "Other instructions."}}};

const ElementRow kMaterialElement{
    .type = "material",
    .meaning = "A diffuse surface; both sides of every surface reflect, nothing passes through.",
    .attributes = {kIdAttribute, {"reflectance", &kFractionType, required}}};

const ElementRow kHousingElement{
    .type = "housing",
    .meaning =
        "The body of the luminaire. It shades and absorbs light from other luminaires and from the "
        "room. Without it light passes through luminaires. The luminaire's own light does not "
        "change: its photometry was measured with the housing. The face is in the opening. If the "
        "opening is a body (with a luminous height), the housing is that body. A luminaire with "
        "several emitters has a flat face in each opening.",
    .attributes = {kMaterialAttribute,
                   {"depth", &kPositiveType, optional,
                    "Depth of the housing behind a flat opening, for luminaires on a surface or in "
                    "the open. Without it there is only the face, as for recessed luminaires. With "
                    "several emitters one box encloses all openings; its depth is measured along "
                    "the luminaire's axis from the foremost opening."},
                   {"size", &kSize2Type, optional,
                    "Size along C0 and along C90, if the housing is larger than the opening. With "
                    "several emitters it is the size of the box, which needs a depth."},
                   {"dimensions", &kHousingDimensionsType, optional,
                    "file: size and depth are those of the luminaire in its photometry file "
                    "(EULUMDAT)."},
                   {"file", &kTextType, optional,
                    "A mesh file (see mesh) instead of depth, size and dimensions, with this "
                    "material. x is C0, y is C90, and z points backwards (up for a luminaire that "
                    "shines down). The origin is the centre of the opening, or the luminaire's "
                    "position with several emitters. The mesh is behind flat openings, which keep "
                    "their faces, and within openings that are bodies."},
                   kMeshFormatAttribute,
                   kMeshNodeAttribute,
                   {"position", &kVectorType, optional,
                    "Position of the mesh's origin in these axes (0 0 0)."},
                   {"rotation", &kNumberType, optional, "Rotation of the mesh about z."},
                   kMeshScaleAttribute,
                   kMeshUpAttribute,
                   kMeshUnitsAttribute}};

const ElementRow kPackageElement{
    .type = "package",
    .meaning =
        "A lamp, driver or current that the luminaire is available with. Packages that no type "
        "uses have no effect; 'luxgate advise --packages' chooses among them.",
    .attributes = {{kArticleName, &kTextType, required, "Names the package, once in its type."},
                   {"flux-lm", &kPositiveType, required,
                    "Luminous flux of the luminaire with it; the distribution stays the file's."},
                   {"power-w", &kPositiveType, required, "Input power of the luminaire with it."},
                   {"price", &kNonNegativeType, optional,
                    "Price of one luminaire with it; the type's price if not given."}}};

const ElementRow kLuminaireTypeElement{
    .type = "luminaireType",
    .meaning =
        "A photometry file and how it is used. If the file has several lights, lamp-set, variant "
        "or emitter selects one. emitter=\"all\" takes those of a GLDF variant together.",
    .attributes =
        {kIdAttribute,
         {"photometry", &kTextType, required,
          "LM-63 (.ies), EULUMDAT (.ldt), TM-33 (.xml) or GLDF (.gldf) file."},
         {"flux-lm", &kPositiveType, optional,
          "Luminous flux of the luminaire, instead of the file's."},
         {"power-w", &kPositiveType, optional, "Input power, instead of the file's."},
         {kPackageName, &kTextType, optional,
          "The article of a package below, instead of flux-lm and power-w. Luminaires of this type "
          "have its flux and power."},
         {"price", &kNonNegativeType, optional,
          "Price of one luminaire, in the project's own currency, for 'luxgate sweep'. Light and "
          "verdicts do not depend on it."},
         {"maintenance-factor", &kPositiveFractionType, optional,
          "Either this or any of the four parts llmf, lsf, lmf and rsmf (1 if not given; their "
          "product counts). If none is given, that of the root element counts. Without both it is "
          "1 for the project's own limits, and rows of a standard are not judged."},
         {"llmf", &kPositiveFractionType},
         {"lsf", &kPositiveFractionType},
         {"lmf", &kPositiveFractionType},
         {"rsmf", &kPositiveFractionType},
         {"opening", &kOpeningType, optional,
          "point: let all light leave the centre instead of the luminous opening of the file.",
          "file"},
         {"interpolation", &kInterpolationType, optional,
          "Between the file's angles, linear or cubic (Hermite, without overshoot).", "linear"},
         {"lamp-set", &kCountType, optional, "The number of an EULUMDAT lamp set."},
         {"variant", &kTextType, optional, "The id of a GLDF variant."},
         {"emitter", &kTextType, optional,
          "The id of a GLDF emitter (id#n: its n-th fitting), or several ids separated by blanks. "
          "all: the emitters of the variant that shine together, each at its place in one "
          "luminaire. Or the id, description or number of a TM-33 emitter."}},
    .children = {{"housing", &kHousingElement}, {kPackageName, &kPackageElement}}};

const ElementRow kDimElement{
    .type = "dim",
    .attributes = {kGroupNamedAttribute,
                   {"level", &kFractionType, required,
                    "Share of the flux at full output. For rules about the end of an emergency's "
                    "rated duration it is the share that the battery still gives then, by the "
                    "manufacturer's data."}}};

const ElementRow kSceneElement{
    .type = "lightScene",
    .meaning = "Dimming levels. Groups that are not named and luminaires without a group are at 1.",
    .attributes = {kIdAttribute},
    .children = {{"dim", &kDimElement}}};

const ElementRow kEnergyPartElement{
    .type = "energyPart",
    .meaning =
        "Other factors for a dimming group; those not given are those of the element around.",
    .attributes = {kGroupNamedAttribute,
                   {"occupancy", &kPositiveFractionType, optional, "Fo of EN 15193."},
                   {"daylight", &kPositiveFractionType, optional, "FD of EN 15193."},
                   {"constant-illuminance", &kPositiveFractionType, optional, "Fc of EN 15193."}}};

const ElementRow kEnergyElement{
    .type = "energy",
    .meaning =
        R"(How the light of a room is used, for requirements on LENI, at most once. In the root element it applies to all rooms
without their own. Factors are 1 if not given.)",
    .attributes = {{"day-hours", &kHoursType, required, "Hours in a year with daylight."},
                   {"night-hours", &kHoursType, required, "Hours in a year without daylight."},
                   kOccupancyAttribute,
                   kDaylightAttribute,
                   kConstantIlluminanceAttribute,
                   {"parasitic-kwh-m2", &kNonNegativeType, required,
                    "Energy of controls and emergency charging in a year by floor area."}},
    .children = {{"part", &kEnergyPartElement}}};

// Objects.
const ElementRow kBoxElement{
    .type = "box",
    .meaning = "position: the corner with the smallest x, y and z before it is rotated.",
    .attributes = {kIdAttribute,
                   {"size", &kSizeType, required},
                   kPositionAttribute,
                   kRotationAttribute,
                   kMaterialAttribute,
                   kRepeatAttribute,
                   kStepAttribute}};

const std::vector<AttributeRow> kLuminousAttributes{
    kGroupAttribute,
    {"power-w", &kPositiveType, optional, "Of a surface that sends light: its input power."},
    {"price", &kNonNegativeType, optional,
     "Of a surface that sends light, in the project's own currency, for 'luxgate sweep'."},
    {"maintenance-factor", &kPositiveFractionType, optional,
     "Of a surface that sends light; the project's if not given."}};

const ElementRow kQuadElement{
    .type = "quad",
    .meaning =
        "A parallelogram with the sides u and v. It covers a surface of the room or of a box if it "
        "lies exactly in it.",
    .attributes = {
        kIdAttribute,
        {"origin", &kVectorType, required},
        {"u", &kVectorType, required},
        {"v", &kVectorType, required},
        kMaterialAttribute,
        kRepeatAttribute,
        kStepAttribute,
        {"luminous-exitance", &kPositiveType, optional,
         "lm/m2: the rectangle sends light, evenly and diffusely, to the side of u x v; its "
         "luminance is that divided by pi, in cd/m2. It reflects as its material says."},
        kLuminousAttributes[0],
        kLuminousAttributes[1],
        kLuminousAttributes[2],
        kLuminousAttributes[3]}};

const ElementRow kPolygonElement{.type = "polygon",
                                 .attributes = {kIdAttribute,
                                                {"points", &kCornersType, required},
                                                kMaterialAttribute,
                                                kRepeatAttribute,
                                                kStepAttribute}};

const ElementRow kMapElement{.type = "materialMap",
                             .meaning = "The material of what has this name in the file.",
                             .attributes = {{"name", &kTextType, required}, kMaterialAttribute}};

const ElementRow kMeshElement{
    .type = "mesh",
    .meaning =
        R"(A mesh file: Wavefront OBJ, glTF 2.0 (.gltf or .glb), STL or PLY. OBJ, STL and PLY files do not say units and up,
so that both attributes are required; glTF is always in metres with y up, so that they are not needed. Each map
gives the faces of one of the file's materials (usemtl in OBJ; "default" for all of an STL or PLY file) a material,
the attribute "material" all others.)",
    .attributes = {kIdAttribute, kFileAttribute, kMeshFormatAttribute, kMeshNodeAttribute,
                   kPositionAttribute, kRotationAttribute, kMeshScaleAttribute, kMeshUpAttribute,
                   kMeshUnitsAttribute, kMaterialOfOthersAttribute, kRepeatAttribute,
                   kStepAttribute},
    .children = {{"map", &kMapElement}}};

const ElementRow kAssemblyElement{
    .type = "assembly",
    .meaning =
        "Objects that are placed and repeated together, nested at most 16 levels deep. Parts are "
        "named assembly.part.",
    .attributes = {kIdAttribute, kPositionAttribute, kRotationAttribute, kRepeatAttribute,
                   kStepAttribute},
    .children = {{.group = &kObjects}}};

// Luminaires.
const ElementRow kLuminaireElement{
    .type = "luminaire",
    .attributes = {kIdAttribute,
                   kTypeAttribute,
                   {"position", &kVectorType, required, "Centre of the luminous opening."},
                   kAxisAttribute,
                   {"aim", &kVectorType, optional, "Instead of axis, a point to shine at."},
                   kC0RotationAttribute,
                   kC0Attribute,
                   kGroupAttribute}};

const ElementRow kLuminaireGridElement{
    .type = "luminaireGrid",
    .meaning =
        R"(A rectangular array of this size, half a spacing from its edges: id[column,row] is at
((column + 0.5) / columns, (row + 0.5) / rows) of the size.)",
    .attributes = {kIdAttribute,
                   kTypeAttribute,
                   {"origin", &kVectorType, required},
                   {"size", &kSize2Type, required},
                   {"rows", &kCountType, required},
                   {"columns", &kCountType, required},
                   {"array-rotation", &kNumberType, optional,
                    "Turns the array about its origin, with its luminaires."},
                   kAxisAttribute,
                   kC0RotationAttribute,
                   kC0Attribute,
                   kGroupAttribute}};

const ElementRow kLuminaireLineElement{
    .type = "luminaireLine",
    .meaning = "id[i] along a line.",
    .attributes = {kIdAttribute,
                   kTypeAttribute,
                   {"from", &kVectorType, required},
                   {"to", &kVectorType, required},
                   {"count", &kCountType, required},
                   {"edge", &kLineEndsType, optional,
                    "half: half a spacing at both ends. end: the first and the last are at the "
                    "ends (count from 2).",
                    "half"},
                   kAxisAttribute,
                   kC0RotationAttribute,
                   kC0Attribute,
                   kGroupAttribute}};

const ElementRow kLuminaireRingElement{
    .type = "luminaireRing",
    .meaning = "id[i] on a horizontal circle.",
    .attributes = {
        kIdAttribute,
        kTypeAttribute,
        {"centre", &kVectorType, required},
        {"radius", &kPositiveType, required},
        {"count", &kCountType, required},
        {"start", &kNumberType, optional, "Angle of the first from the x axis."},
        {"turn", &kRingTurnType, optional, "yes: each luminaire is turned by its angle.", "yes"},
        kAxisAttribute,
        kC0RotationAttribute,
        kC0Attribute,
        kGroupAttribute}};

const ElementRow kLuminaireListElement{
    .type = "luminaireList",
    .meaning =
        R"(Luminaires of a CSV file, named id.name. Its first line names the columns: name, type, x_m, y_m, z_m; optionally
axis_x, axis_y, axis_z or aim_x_m, aim_y_m, aim_z_m, and rotation_deg, group, with the meanings that the attributes
of luminaires have. In metres, whatever the unit of the project; x_mm, aim_x_mm and so on are in mm, and x_cm, x_in and
x_ft are other units.)",
    .attributes = {kIdAttribute, kFileAttribute}};

const ElementGroup kObjects{"object",
                            {{"box", &kBoxElement},
                             {"quad", &kQuadElement},
                             {"polygon", &kPolygonElement},
                             {"mesh", &kMeshElement, kOfMesh},
                             {"assembly", &kAssemblyElement, kOfAssembly},
                             {"luminaire", &kLuminaireElement},
                             {"luminaire-grid", &kLuminaireGridElement},
                             {"luminaire-line", &kLuminaireLineElement},
                             {"luminaire-ring", &kLuminaireRingElement},
                             {"luminaires", &kLuminaireListElement}}};

// Calculation planes.
const ElementRow kHoleElement{.type = "hole", .attributes = {{"points", &kCornersType, required}}};

const ElementRow kDeviationElement{
    .type = "deviation",
    .meaning =
        "The plane differs from the plane that the standard's number is about. The number is "
        "compared nevertheless, and every report says so."};

const ElementRow kWaiverElement{.type = "waiver",
                                .meaning =
                                    "These checks of the row are waived up to a last day: they do "
                                    "not count if they fail or are undecided."};

const ElementRow kRequireElement{
    .type = "requirement",
    .meaning = "What the plane must meet; see rules/README.md for the meaning of the attributes.",
    .children = {{"deviation", &kDeviationElement}, {"waiver", &kWaiverElement}}};

const ElementRow kPlaneElement{
    .type = "plane",
    .meaning = R"(Exactly one of these forms:
height: in a room, the whole footprint at this height above the floor, facing up.
origin, u, v: a rectangle with the full sides u and v, which are perpendicular; it faces u x v.
points: a flat polygon, with holes if needed; it faces the side from which its corners run counter-clockwise.
The grid's first direction is along its first side, or along its longest side if the first is at an angle to that.
on: in a room, floor, ceiling, wall1, wall2 ..., facing into the room; wall1 begins at the footprint's first
corner (rooms with "size": wall1 is y = 0, wall2 x = max, wall3 y = max, wall4 x = 0).
on-top-of: the upper face of a box, named as in messages: id, id[i,j,k], assembly.id ...
file: CSV file with the header x_m,y_m,z_m,nx,ny,nz: points and the directions they face. x_mm, x_cm, x_in and x_ft
are other units; x, y and z without one are in metres, whatever the unit of the project.
Grid: count along u and v, or spacing (rounded up), or the rule of EN 12464-1 if neither is given.
quantity: what the points measure, planar illuminance if it is not given. Cylindrical and hemispherical points
have the direction that the plane (or the point of a list) faces for an axis: an upright cylinder on a plane that
faces up. Semicylindrical points stand upright and look in a horizontal direction: the attribute "direction" of
planes, the normals of a list. ugr: unified glare rating of eyes at the points that look that way, without a unit.
modelling: cylindrical illuminance / planar illuminance on the plane's axis, without a unit. cylindrical-4: the mean of
four vertical planes (of an upright axis: +x, +y, -x, -y) in place of the cylindrical integral.)",
    .attributes = {kIdAttribute,
                   kNameAttribute,
                   kWasAttribute,
                   kTagsAttribute,
                   {"height", &kNonNegativeType},
                   {"origin", &kVectorType},
                   {"u", &kVectorType},
                   {"v", &kVectorType},
                   {"points", &kCornersType},
                   {"on", &kRoomSurfaceType},
                   {"on-top-of", &kBoxNameType},
                   {"file", &kTextType},
                   {"margin", &kNonNegativeType, optional,
                    "Width of the strip along the outline that has no points."},
                   kCountAttribute,
                   kSpacingAttribute,
                   kRoundingAttribute,
                   {"quantity", &kPlaneQuantityType, optional, "What the points measure.",
                    "planar"},
                   {"direction", &kVectorType, optional, "Where semicylindrical points look."},
                   {"travel", &kVectorType, optional,
                    "Horizontal direction of walking on an escape route. Needed if one side is "
                    "less than twice the other; otherwise the longer side counts."}},
    .children = {{"hole", &kHoleElement}, {"require", &kRequireElement}}};

const ElementRow kRouteElement{
    .type = "route",
    .meaning =
        R"(An escape route: a strip of a width about a centre line, which may have bends and stairs. Its points follow the line in
an odd number of rows, so that one row is on the line. Their normals are vertical. They are on the surface that people
walk on: the highest between 0.5 m below and 0.3 m above the line. Objects above that, up to 1 m, are obstacles. The
floor of a room is such a surface; in the open it is z = 0 if there is no surface below. Masks of rule packs follow the
line and the width.)",
    .attributes = {kIdAttribute,
                   kNameAttribute,
                   kWasAttribute,
                   kTagsAttribute,
                   {"points", &kRouteLineType, required,
                    "The centre line. z is the approximate height of the walking surface."},
                   {"width", &kPositiveType, required},
                   {"height", &kNonNegativeType, optional,
                    "Height of the points above the walking surface (0)."},
                   {"spacing", &kSpacingsType, optional,
                    "Largest distance of points, or one along and one across the route; 0.5 m and "
                    "at least 5 rows if not given."}},
    .children = {{"require", &kRequireElement}}};

// Roads.
const ElementRow kLuminaireRowElement{
    .type = "luminaireRow",
    .meaning = "An endless row of equal luminaires along a road, at equal spacing.",
    .attributes = {
        kIdAttribute,
        kTypeAttribute,
        {"side", &kRoadSideType, required,
         "The edge of the carriageway where it is, seen in the direction of traffic."},
        {"height", &kPositiveType, required, "Of the luminous openings above the road."},
        {"overhang", &kNumberType, optional,
         "Of the luminous openings over the carriageway; below 0: beside it (0)."},
        {"tilt", &kTiltType, optional, "How far the street side is lifted, in degrees (0)."},
        {"shift", &kNumberType, optional,
         "Distance along the road from the beginning of the field to one of its luminaires (0). "
         "Half a spacing staggers a row against the other."},
        {"street", &kStreetPlaneType, optional,
         "The half-plane of the photometry that faces the street; C90 of EULUMDAT files and C0 of "
         "all others if not given."},
        kGroupAttribute}};

const ElementRow kRoadStripElement{
    .type = "roadStrip",
    .meaning = "A footway or another strip along the road: a plane as long as the field.",
    .attributes = {kIdAttribute,
                   kNameAttribute,
                   kWasAttribute,
                   kTagsAttribute,
                   {"side", &kRoadSideType, required},
                   {"gap", &kNonNegativeType, optional, "From the edge of the carriageway (0)."},
                   {"width", &kPositiveType, required}},
    .children = {{"require", &kRequireElement}}};

const ElementRow kRoadElement{
    .type = "road",
    .meaning =
        R"(A straight, level road with regular rows of luminaires. Other objects of the project do not affect it, and it does not
affect them. Its carriageway is a plane with the road's id, from one luminaire to the next, with the points of
EN 13201-3. Requirements on it can be road-luminance, road-Uo, road-Ul, TI, REI and illuminances; requirements on its
strips can be illuminances. The direction of traffic is that of x before the rotation. Seen in this direction, the road
is to the left of the origin.)",
    .attributes =
        {{"id", &kRoomIdType, required},
         kNameAttribute,
         kWasAttribute,
         kTagsAttribute,
         {"origin", &kVectorType, optional,
          "Point on the right edge of the carriageway where the field begins (0 0 0)."},
         {"rotation", &kTurnType, optional, "Of the direction of traffic, from x (0)."},
         {"width", &kPositiveType, required, "Of the carriageway."},
         {"lanes", &kCountType, required, "Equally wide ones."},
         {"oncoming-lanes", &kCountOrNoneType, optional,
          "Number of lanes with oncoming traffic (0)."},
         {"traffic", &kTrafficSideType, optional,
          "The side on which people drive, with oncoming traffic (right)."},
         {"spacing", &kPositiveType, required, "From one luminaire of a row to the next."},
         {"surface", &kRoadSurfaceType, required, "Table of reduced luminance coefficients."},
         {"q0", &kQ0Type, optional,
          "Average luminance coefficient that the table is scaled to; its own if not given."},
         {"right-strip", &kNonNegativeType, optional,
          "Width beside the right edge that counts for REI; the width of a lane if not given. 0 "
          "means none, as beside another carriageway."},
         {"left-strip", &kNonNegativeType, optional, "The same at the left edge."}},
    .children = {{"luminaire-row", &kLuminaireRowElement},
                 {"strip", &kRoadStripElement},
                 {"require", &kRequireElement}}};

// Workplaces.
const ElementRow kZoneElement{
    .type = "zone",
    .meaning =
        "A difference from the rule for the zones of a role. The area is origin and size, or "
        "footprint, in the room's x and y.",
    .attributes = {
        {"role", &kIdType, required, "E.g. \"cylinder\", \"wall\" (all walls) or \"wall.2\"."},
        kHeightAboveFloorAttribute,
        {"margin", &kNonNegativeType, optional,
         "Along the walls, or along the outline of an area that is given."},
        kZoneOriginAttribute,
        kZoneSizeAttribute,
        kZoneFootprintAttribute,
        kCountAttribute,
        kSpacingAttribute,
        kRoundingAttribute,
        {"because", &kAnyText}}};

const ElementRow kWithoutElement{
    .type = "zoneLeftOut",
    .meaning =
        "Omits a role other than the task, up to a last day. After that day the row is not judged.",
    .attributes = {{"role", &kIdType, required}, kBecauseAttribute, kByAttribute, kUntilAttribute}};

const ElementRow kWorkplaceElement{
    .type = "workplace",
    .meaning =
        R"(Planes of a room, with grids and limits, as the row of a rule pack requires: "id.task", "id.surround",
"id.wall.1" ... The task area is the whole room, or an area in the room's x and y (origin and size, or footprint). Or it
is upright: a part of a wall, or a face. See rules/README.md.)",
    .attributes =
        {kIdAttribute,
         kNameAttribute,
         kWasAttribute,
         kTagsAttribute,
         kZoneOriginAttribute,
         kZoneSizeAttribute,
         kZoneFootprintAttribute,
         kHeightAboveFloorAttribute,
         {"wall", &kCountType, optional, "The task is on the wall of this number."},
         {"along", &kFromToType, optional,
          "The part of the wall, from its left end as seen from the room; the whole wall if not "
          "given."},
         {"face", &kFootType, optional,
          "The task is an upright face. This is its foot in the room's x and y, from left to right "
          "as seen from the front."},
         {"heights", &kFromToType, optional,
          "The lower and the upper edge of an upright task, above the floor."},
         {"lean", &kLeanType, optional, "Of a face: degrees that it leans back.", "0"},
         {"glare", &kGlareMethodType, optional,
          "How glare is judged: by the tabular method, or also at observers. If not given, by the "
          "table if it applies to the room. The table is always required there."},
         {"front-wall", &kCountType, optional,
          "The number of the wall in front of the people who work there. Other walls may be darker "
          "if the row says so."},
         {kTaskPlaceName, &kTaskPlaceType, optional,
          "The place of the task in the room is not known yet."}},
    .children = {{"zone", &kZoneElement},
                 {"without", &kWithoutElement},
                 {"deviation", &kDeviationElement},
                 {"waiver", &kWaiverElement}}};

const ElementRow kWorkplaceGridElement = [] {
  ElementRow grid = kWorkplaceElement;
  grid.type = "workplaceGrid";
  grid.meaning =
      R"(The same workplace several times: "id[0,0]", "id[1,0]" ..., its area and those of its zones moved by step along x
and y. The area is given. Walls and ceiling are made once, as for all workplaces of a room.)";
  std::erase_if(grid.attributes,
                [](const AttributeRow& one) { return one.name == kTaskPlaceName; });
  grid.attributes.push_back(
      {"repeat", &kCounts2Type, required, "Numbers of copies along x and y."});
  grid.attributes.push_back({"step", &kVector2Type, required, "Distances of the copies."});
  return grid;
}();

// Rooms and the root.
const ElementRow kPrismRoomElement{
    .type = "room",
    .meaning =
        R"(A closed prism: no light enters or leaves. Either size (x y z), or footprint and height. ceiling, walls, floor:
material ids (required); wall-materials: one id per wall, instead of "walls" for all (which is still required).

Or a space of a gbXML file, in the building's coordinates: file and space (its id) instead of all of these. Each map
gives a material to the surfaces of one surfaceType, or to the openings of one openingType. The attribute "material"
is for all others except Air, which has no surface. Every surface next to the space counts, without its openings, which
are separate surfaces. An InteriorFloor or Ceiling counts as it is seen from the room. Planes in such a room cannot use
"on". They can use "height" only if the space has an outline (PlanarGeometry) or its floor is a single flat polygon.

Or a closed shell of a mesh file (its contents tell it from gbXML): file, units, up and the other attributes of mesh.
All objects in such a room are in world coordinates. Faces may point inward or outward. The room is the shell that
contains all others, which are solids. If that is not clear, "shell" names one, as the message does. Open surfaces
are taken with a warning if they enclose a volume. Planes in such a room cannot use "on". They can use "height" only
if the lowest faces are a single level polygon and no other faces point up.)",
    .attributes = {{"id", &kRoomIdType, required},
                   kNameAttribute,
                   kWasAttribute,
                   kTagsAttribute,
                   {"origin", &kVectorType},
                   {"size", &kSizeType},
                   {"footprint", &kFootprintType},
                   {"height", &kPositiveType},
                   {"ceiling", &kIdType},
                   {"walls", &kIdType},
                   {"floor", &kIdType},
                   {"wall-materials", &kIdsType}},
    .children = {{.group = &kObjects},
                 {"plane", &kPlaneElement},
                 {"route", &kRouteElement},
                 {"workplace", &kWorkplaceElement, kOfWorkplace},
                 {"workplace-grid", &kWorkplaceGridElement, kOfWorkplaceGrid},
                 {"energy", &kEnergyElement, kOfEnergy}}};

const ElementRow kGbxmlRoomElement{
    .type = "room",
    .attributes = {{"id", &kRoomIdType, required},
                   kNameAttribute,
                   kWasAttribute,
                   kTagsAttribute,
                   {"file", &kTextType},
                   {"space", &kTextType},
                   kMaterialOfOthersAttribute},
    .children = {{.group = &kObjects},
                 {"plane", &kPlaneElement},
                 {"route", &kRouteElement},
                 {"workplace", &kWorkplaceElement, kOfWorkplace},
                 {"workplace-grid", &kWorkplaceGridElement, kOfWorkplaceGrid},
                 {"energy", &kEnergyElement, kOfEnergy},
                 {"map", &kMapElement}}};

const ElementRow kMeshRoomElement{
    .type = "room",
    .attributes = {{"id", &kRoomIdType, required},
                   kNameAttribute,
                   kWasAttribute,
                   kTagsAttribute,
                   {"file", &kTextType},
                   kMeshFormatAttribute,
                   kMeshNodeAttribute,
                   {"shell", &kMeshShellType, optional,
                    "The closed shell of the mesh that is the room, counted from the largest. "
                    "\"all\": the room is the space between all surfaces, such as walls with a "
                    "thickness. Points outside of it are not detected then."},
                   kPositionAttribute,
                   kRotationAttribute,
                   kMeshScaleAttribute,
                   kMeshUpAttribute,
                   kMeshUnitsAttribute,
                   kMaterialOfOthersAttribute},
    .children = kGbxmlRoomElement.children};

namespace {

const ElementRow kRoomElement =
    either_of(either_of(kPrismRoomElement, kGbxmlRoomElement), kMeshRoomElement);

const ValueType kRoomPatternType{
    .name = "roomPattern", .base = &kAnyText, .pattern = R"([A-Za-z0-9_.:\-*?]+)"};
const ValueType kRoomPatternsType{
    .name = "roomPatterns",
    .meaning = "Ids separated by blanks, in which * stands for any text and ? for any character.",
    .item = &kRoomPatternType,
    .least = 1};

}  // namespace

const ElementRow kBuildingElement{
    .type = "building",
    .meaning =
        R"(Requirements on several rooms together: power density and LENI, which are their total power or energy over their total
floor area. A room may exceed the limit if others compensate for it.)",
    .attributes = {kIdAttribute,
                   kNameAttribute,
                   kWasAttribute,
                   {"rooms", &kRoomPatternsType, optional,
                    "Ids or patterns of rooms: \"office-* hall\"; all rooms if not given. Roads "
                    "and the open space are not rooms."}},
    .children = {{"require", &kRequireElement}}};

const ElementRow kProjectElement{
    .type = "project",
    .attributes = {{"version", &kVersionType, required},
                   kNameAttribute,
                   {"units", &kUnitsType, optional,
                    "Unit of all lengths in this file, except those of requirements (at, and from "
                    "and to of heights), which are in metres. Meshes may have their own unit, and "
                    "columns of CSV files name theirs.",
                    "m"},
                   {"maintenance-factor", &kPositiveFractionType, optional,
                    "For all luminaire types without their own."},
                   {"north", &kTurnType, optional,
                    "Direction of north in plan, in degrees from +x counter-clockwise: 90 is +y. "
                    "Only drawings use it."}},
    .children = {{kAboutName, &kAboutElement},
                 {kMaintenancePlanName, &kMaintenancePlanElement},
                 {"material", &kMaterialElement},
                 {"luminaire-type", &kLuminaireTypeElement, kOfLuminaireType},
                 {"scene", &kSceneElement, kOfScene},
                 {"room", &kRoomElement, kOfRoom},
                 {"road", &kRoadElement, kOfRoad},
                 {"building", &kBuildingElement},
                 {"plane", &kPlaneElement},
                 {"route", &kRouteElement},
                 {"energy", &kEnergyElement, kOfCommonEnergy},
                 {.group = &kObjects}}};

const ChildRow kProjectRoot{"luxgate", &kProjectElement, kOfRoot};

const std::string_view kProjectMeaning =
    R"(Project file of luxgate, version 1.

Axes: x and y horizontal, z up, right-handed. Lengths are in the unit of the root's attribute "units"; angles are in
degrees, counter-clockwise seen from above. Numbers use a decimal point; lists are separated by blanks. Objects in a
room are written in room coordinates (origin = the room's attribute "origin"), parts of an assembly in the
assembly's coordinates, everything else in world coordinates.

luxgate checks more than a schema can say: which attributes exclude each other, that polygons are simple, that
groups, walls and boxes exist, and the contents of the files named here. File names are relative to the project
file and stay in its folder or below it.)";

}  // namespace calc
