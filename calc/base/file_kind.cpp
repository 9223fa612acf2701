#include "calc/base/file_kind.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/encoding.h"
#include "calc/base/line_cursor.h"
#include "calc/base/text.h"
#include "calc/base/utf8.h"
#include "calc/base/xml_encoding.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <utility>
#include <vector>

namespace calc {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t kHeadBytes = 8000;
constexpr std::size_t kTailBytes = 65536;

// What the predicates look at.
struct FileHead {
  std::string_view bytes;  // the file's first ones
  std::string_view tail;   // and its last: where ZIP archives list their files
  std::string text;        // of them, in UTF-8, without blanks around
  std::string element;     // the first one, if it is XML
};

FileHead head_of(std::string_view bytes) {
  const std::string_view tail = bytes.substr(bytes.size() - std::min(bytes.size(), kTailBytes));
  FileHead head{bytes.substr(0, kHeadBytes), tail, "", ""};
  const std::string start = start_of_text(bytes, kHeadBytes);
  head.text = trim(start);
  if (looks_like_xml(bytes)) head.element = first_element_name(head.text);
  return head;
}

bool begins(const FileHead& head, std::string_view magic) { return head.bytes.starts_with(magic); }
bool holds(const FileHead& head, std::string_view part) {
  return head.bytes.find(part) != std::string_view::npos;
}
bool is_zip(const FileHead& head) { return begins(head, "PK\x03\x04"sv); }
// An archive with a file of such a name; what it packs may hold one, too: ask for the outer first.
bool is_zip_with(const FileHead& head, std::string_view name) {
  return is_zip(head) && (holds(head, name) || head.tail.find(name) != std::string_view::npos);
}

bool is_dwg(const FileHead& head) {
  return begins(head, "AC10"sv) && head.bytes.size() > 6 && is_digit(head.bytes[4]) &&
         is_digit(head.bytes[5]) && head.bytes[6] == '\0';
}

// Pairs of lines, group code and value: comments (999), then 0 and SECTION.
bool is_text_dxf(const FileHead& head) {
  const std::vector<std::string_view> words = split_words(head.text);
  if (words.size() < 2 || (words[0] != "0" && words[0] != "999")) return false;
  if (words[0] == "0") return words[1] == "SECTION";
  for (std::size_t i = 1; i + 1 < words.size(); ++i) {
    if (words[i] == "0" && words[i + 1] == "SECTION") return true;
  }
  return false;
}

// The main chunk, and in it the version or the model.
bool is_3ds(const FileHead& head) {
  const std::string_view inner = head.bytes.substr(std::min<std::size_t>(6, head.bytes.size()), 2);
  return begins(head, "\x4D\x4D"sv) && (inner == "\x02\0"sv || inner == "\x3D\x3D"sv);
}

// "modifier type name", then a number of arguments.
bool is_radiance_scene(const FileHead& head) {
  constexpr std::array kTypes{
      "polygon"sv,   "sphere"sv,     "bubble"sv, "cone"sv,      "cup"sv,        "cylinder"sv,
      "tube"sv,      "ring"sv,       "source"sv, "mesh"sv,      "instance"sv,   "plastic"sv,
      "metal"sv,     "trans"sv,      "light"sv,  "illum"sv,     "glow"sv,       "spotlight"sv,
      "mirror"sv,    "dielectric"sv, "glass"sv,  "interface"sv, "brightdata"sv, "brightfunc"sv,
      "colorpict"sv, "mixfunc"sv};
  LineCursor lines(head.text);
  while (const std::optional<std::string_view> line = lines.next()) {
    const std::vector<std::string_view> words = split_words(*line);
    if (words.empty() || words[0].starts_with('#') || words[0].starts_with('!')) continue;
    const std::vector<std::string_view> next = split_words(lines.next().value_or(""));
    return words.size() == 3 && std::find(kTypes.begin(), kTypes.end(), words[1]) != kTypes.end() &&
           !next.empty() && parse_integer(next[0]).has_value();
  }
  return false;
}

// Only statements of the format, up to the first vertex.
bool is_obj(const FileHead& head) {
  constexpr std::array kStatements{"v"sv, "vn"sv, "vt"sv,     "vp"sv,    "o"sv,
                                   "g"sv, "s"sv,  "mtllib"sv, "usemtl"sv};
  LineCursor lines(head.text);
  while (const std::optional<std::string_view> line = lines.next()) {
    const std::vector<std::string_view> words = split_words(line->substr(0, 200));
    if (words.empty() || words[0].starts_with('#')) continue;
    if (std::find(kStatements.begin(), kStatements.end(), words[0]) == kStatements.end()) break;
    if (words[0] == "v") {
      return words.size() >= 4 && std::all_of(words.begin() + 1, words.begin() + 4, [](auto word) {
               return parse_number(word).has_value();
             });
    }
  }
  return false;
}

bool is_text_stl(const FileHead& head) {
  return head.text.starts_with("solid") && head.text.find("facet") != std::string::npos;
}

// The first line is any text; the next ones are type, symmetry, planes, their step, angles and
// their step.
bool is_eulumdat(const FileHead& head) {
  LineCursor lines(head.text);
  if (!lines.next()) return false;
  constexpr std::array kHighest{3.0, 4.0, 721.0, 360.0, 361.0, 180.0};
  for (const double highest : kHighest) {
    const std::optional<double> number = parse_number(trim(lines.next().value_or("")));
    if (!number || *number < 0.0 || *number > highest) return false;
  }
  return lines.next().has_value();
}

bool is_element(const FileHead& head, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), head.element) != names.end();
}

// Advice: sentences without a full stop at the end; "..." becomes the name of the file.
constexpr std::string_view kToMesh = "Export it as OBJ, STL, PLY or glTF";
constexpr std::string_view kToDxf = "Save it as DXF, which 'luxgate import' reads";
constexpr std::string_view kToDrawing = "Export it as IFC or DXF";
constexpr std::string_view kImport = "'luxgate import' begins a project with it";
constexpr std::string_view kToRooms =
    "Export the model as IFC, its rooms as gbXML, or bodies as OBJ, STL, PLY or glTF";
constexpr std::string_view kToPhotometry =
    "Ask the manufacturer for LM-63 (.ies), EULUMDAT (.ldt), TM-33 or GLDF";
constexpr std::string_view kUnpack = "Unpack it and name the file inside";
constexpr std::string_view kToCsv = "Save the sheet as CSV";
constexpr std::string_view kToText = "Pictures and documents cannot be read here";
constexpr std::string_view kAsPhotometry = "Use it as <luminaire-type photometry=\"...\">";
constexpr std::string_view kAsMesh = "Use it as <room file=\"...\"> or <mesh file=\"...\">";
constexpr std::string_view kAsGbxml = "Use it as <room file=\"...\" space=\"...\">";
constexpr std::string_view kAsProject = "'luxgate check' reads it";
constexpr std::string_view kAsResult = "'luxgate report' and 'luxgate compare' read it";
constexpr std::string_view kAsRules = "'luxgate check --rules' and 'luxgate rules' read it";
constexpr std::string_view kAsPolicy = "'luxgate check --policy' reads it";

struct KindRow {
  FileKind kind;
  bool (*is_it)(const FileHead& head);  // null: only the name tells
  std::string_view extensions;          // ".ifc .ifczip", "" = none
};

// The first that fits. Magic numbers before guesses from text.
constexpr KindRow kKinds[] = {
    {{"a PDF document", FileUse::other, kToText},
     [](const FileHead& h) { return holds(h, "%PDF-"sv) && h.bytes.find("%PDF-"sv) < 1024; },
     ".pdf"},
    {{"a PNG picture", FileUse::other, kToText},
     [](const FileHead& h) { return begins(h, "\x89PNG"sv); },
     ".png"},
    {{"a JPEG picture", FileUse::other, kToText},
     [](const FileHead& h) { return begins(h, "\xFF\xD8\xFF"sv); },
     ".jpg .jpeg"},
    {{"a TIFF or GIF picture", FileUse::other, kToText},
     [](const FileHead& h) {
       return begins(h, "II*\0"sv) || begins(h, "MM\0*"sv) || begins(h, "GIF8"sv);
     },
     ".tif .tiff .gif .bmp"},
    {{"an OpenEXR picture", FileUse::other, kToText},
     [](const FileHead& h) { return begins(h, "\x76\x2F\x31\x01"sv); },
     ".exr"},
    {{"a SketchUp model", FileUse::other, kToMesh},
     [](const FileHead& h) { return begins(h, "\xFF\xFE\xFF\x0ES\0k\0e\0t\0"sv); },
     ".skp"},
    {{"an AutoCAD drawing (DWG)", FileUse::other, kToDxf}, is_dwg, ".dwg"},
    {{"an AutoCAD drawing (DXF)", FileUse::drawing, kImport},
     [](const FileHead& h) { return begins(h, "AutoCAD Binary DXF"sv) || is_text_dxf(h); },
     ".dxf"},
    {{"an IFC building model", FileUse::drawing, kImport},
     [](const FileHead& h) {
       return (h.text.starts_with("ISO-10303-21") && holds(h, "IFC"sv)) ||
              is_element(h, {"ifcXML", "iso_10303_28"});
     },
     ".ifc .ifczip .ifcxml"},
    {{"a STEP model", FileUse::other, kToMesh},
     [](const FileHead& h) { return h.text.starts_with("ISO-10303-21"); },
     ".stp .step .p21"},
    {{"an IGES model", FileUse::other, kToMesh}, nullptr, ".igs .iges"},
    {{"an FBX model", FileUse::other, kToMesh},
     [](const FileHead& h) { return begins(h, "Kaydara FBX Binary"sv) || begins(h, "; FBX "sv); },
     ".fbx"},
    {{"a 3DS model", FileUse::other, kToMesh}, is_3ds, ".3ds"},
    {{"a Blender file", FileUse::other, kToMesh},
     [](const FileHead& h) { return begins(h, "BLENDER"sv); },
     ".blend"},
    {{"a Rhino model", FileUse::other, kToMesh},
     [](const FileHead& h) { return begins(h, "3D Geometry File Format"sv); },
     ".3dm"},
    {{"a USD scene", FileUse::other, kToMesh},
     [](const FileHead& h) { return begins(h, "PXR-USDC"sv) || begins(h, "#usda"sv); },
     ".usd .usda .usdc .usdz"},
    {{"a VRML scene", FileUse::other, kToMesh},
     [](const FileHead& h) { return begins(h, "#VRML"sv); },
     ".wrl .vrml"},
    {{"a COLLADA scene", FileUse::other, kToMesh},
     [](const FileHead& h) { return is_element(h, {"COLLADA"}); },
     ".dae"},
    {{"an XML file of another program (X3D, CityGML, LandXML, KML or SVG)", FileUse::other,
      kToMesh},
     [](const FileHead& h) {
       return is_element(h, {"X3D", "CityModel", "LandXML", "kml", "svg"});
     },
     ".x3d .kml .svg"},
    {{"a Git LFS pointer, not the file itself", FileUse::other,
      "Run 'git lfs pull' to get the file"},
     [](const FileHead& h) {
       return begins(h, "version https://git-lfs.github.com/spec/"sv) && h.bytes.size() < 1024;
     },
     ""},
    {{"a web page", FileUse::other, "Save the file behind the link instead"},
     [](const FileHead& h) {
       return is_element(h, {"html", "HTML"}) || h.text.starts_with("<!DOCTYPE html") ||
              h.text.starts_with("<!doctype html");
     },
     ".html .htm"},
    {{"an STF file", FileUse::other, kToRooms},
     [](const FileHead& h) { return h.text.starts_with("[VERSION]") && holds(h, "STFF"sv); },
     ".stf"},
    {{"a Radiance octree or picture", FileUse::other, kToMesh},
     [](const FileHead& h) { return begins(h, "#?RADIANCE"sv) || begins(h, "#?RGBE"sv); },
     ".oct .hdr .pic"},
    {{"a Radiance scene", FileUse::other, kToMesh}, is_radiance_scene, ".rad"},
    {{"a Revit model", FileUse::other, kToRooms},
     [](const FileHead& h) {
       return begins(h, "\xD0\xCF\x11\xE0"sv) && holds(h, "R\0e\0v\0i\0t\0"sv);
     },
     ".rvt .rfa"},
    {{"a GLDF file", FileUse::photometry, kAsPhotometry},
     [](const FileHead& h) { return is_zip_with(h, "product.xml"sv); },
     ".gldf"},
    {{"an Excel workbook", FileUse::other, kToCsv},
     [](const FileHead& h) {
       return is_zip_with(h, "xl/workbook.xml"sv) || is_zip_with(h, "opendocument.spreadsheet"sv);
     },
     ".xlsx .xls .ods"},
    {{"a Word document", FileUse::other, kToText},
     [](const FileHead& h) { return is_zip_with(h, "word/document.xml"sv); },
     ".docx .doc"},
    {{"an L3D body of a luminaire", FileUse::other, kUnpack},
     [](const FileHead& h) { return is_zip_with(h, "structure.xml"sv); },
     ".l3d"},
    {{"a DIALux project", FileUse::other,
      "Export the photometry of its luminaires, and its rooms as IFC, gbXML or DXF"},
     nullptr,
     ".evo .dlx"},
    {{"a DIALux luminaire", FileUse::other, kToPhotometry}, nullptr, ".uld"},
    {{"a Relux file", FileUse::other, kToPhotometry}, nullptr, ".rdf .rolf .rolfz .rxf"},
    {{"an AGi32 file", FileUse::other, kToRooms}, nullptr, ".agi"},
    {{"an OLE compound file (Revit, 3ds Max or an old Office program)", FileUse::other, kToRooms,
      true},
     [](const FileHead& h) { return begins(h, "\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1"sv); },
     ".max"},
    {{"a compressed file", FileUse::other, kUnpack},
     [](const FileHead& h) {
       return begins(h, "\x1F\x8B"sv) || begins(h, "7z\xBC\xAF"sv) || begins(h, "Rar!"sv) ||
              begins(h, "BZh"sv) ||
              begins(h,
                     "\xFD"
                     "7zXZ"sv);
     },
     ".gz .7z .rar .bz2 .xz .tar"},
    {{"a gbXML file", FileUse::gbxml, kAsGbxml},
     [](const FileHead& h) { return is_element(h, {"gbXML"}); },
     ".gbxml"},
    {{"a luxgate project", FileUse::project, kAsProject},
     [](const FileHead& h) { return is_element(h, {"luxgate"}); },
     ""},
    {{"a rule pack", FileUse::rule_pack, kAsRules},
     [](const FileHead& h) { return is_element(h, {"rule-pack"}); },
     ""},
    {{"a policy", FileUse::policy, kAsPolicy},
     [](const FileHead& h) { return is_element(h, {"luxgate-policy"}); },
     ""},
    {{"a TM-33 file", FileUse::photometry, kAsPhotometry},
     [](const FileHead& h) {
       return h.element.starts_with("IESTM33") || is_element(h, {"LuminaireOpticalData"});
     },
     ""},
    {{"an LM-63 file", FileUse::photometry, kAsPhotometry},
     [](const FileHead& h) {
       return h.text.starts_with("IESNA") || h.text.starts_with("IES:LM-63");
     },
     ".ies"},
    {{"an EULUMDAT file", FileUse::photometry, kAsPhotometry}, is_eulumdat, ".ldt"},
    {{"a luxgate result", FileUse::result, kAsResult},
     [](const FileHead& h) {
       return h.text.starts_with('{') &&
              h.text.substr(0, 200).find("\"luxgate-result\"") != std::string::npos;
     },
     ""},
    {{"a glTF model", FileUse::mesh, kAsMesh},
     [](const FileHead& h) {
       return begins(h, "glTF"sv) ||
              (h.text.starts_with('{') && holds(h, "\"asset\""sv) && holds(h, "\"version\""sv));
     },
     ".gltf .glb"},
    {{"a PLY mesh", FileUse::mesh, kAsMesh},
     [](const FileHead& h) { return begins(h, "ply\n"sv) || begins(h, "ply\r"sv); },
     ".ply"},
    {{"an STL mesh", FileUse::mesh, kAsMesh}, is_text_stl, ".stl"},
    {{"an OBJ mesh", FileUse::mesh, kAsMesh}, is_obj, ".obj"},
    {{"a table (CSV)", FileUse::table, ""}, nullptr, ".csv .tsv"},
    {{"a settings file or a map (TOML)", FileUse::settings, ""}, nullptr, ".toml"},
    {{"a JSON file", FileUse::other, ""}, nullptr, ".json"},
    {{"a ZIP archive", FileUse::other, kUnpack, true}, is_zip, ".zip"},
};

// Advice on a kind where `wanted` is needed; "" = none. Bodies are not photometry, rules or tables,
// however they are exported.
std::string_view advice_for(const FileKind& kind, FileUse wanted) {
  const bool is_of_bodies =
      kind.advice == kToMesh || kind.advice == kToRooms || kind.advice == kToDxf;
  if (kind.advice == kToCsv && wanted != FileUse::table) return "";
  if (!is_of_bodies) return kind.advice;
  if (wanted == FileUse::drawing) return kind.advice == kToDxf ? "Save it as DXF" : kToDrawing;
  const bool helps =
      wanted == FileUse::mesh || wanted == FileUse::gbxml || wanted == FileUse::project;
  return helps ? kind.advice : "";
}

// With the name of the file for the first "..."s that stand for it; a file without a name keeps
// them.
std::string with_name(std::string_view advice, std::string_view path) {
  constexpr std::string_view kPlace = "file=\"...\"", kPhotometry = "photometry=\"...\"";
  const std::string name = printable(path.substr(path.rfind('/') + 1));
  std::string text(advice);
  if (name.empty()) return text;
  for (const std::string_view place : {kPlace, kPhotometry}) {
    for (std::size_t at = text.find(place); at != std::string::npos;) {
      const std::size_t dots = at + place.find("...");
      text.replace(dots, 3, name);
      at = text.find(place, dots + name.size());
    }
  }
  return text;
}

}  // namespace

std::string_view words_of(FileUse use) {
  switch (use) {
    case FileUse::mesh:
      return "a mesh (OBJ, STL, PLY or glTF)";
    case FileUse::photometry:
      return "photometry (LM-63, EULUMDAT, TM-33 or GLDF)";
    case FileUse::project:
      return "a luxgate project (XML)";
    case FileUse::gbxml:
      return "gbXML";
    case FileUse::rule_pack:
      return "a rule pack (XML)";
    case FileUse::result:
      return "a result that 'luxgate check --format json' wrote";
    case FileUse::table:
      return "a table of comma-separated values (CSV)";
    case FileUse::drawing:
      return "a drawing (DXF) or a building model (IFC)";
    case FileUse::policy:
      return "a policy (XML)";
    case FileUse::settings:
      return "TOML";
    case FileUse::other:
      break;
  }
  return "";
}

const FileKind* kind_by_content(std::string_view bytes) {
  const FileHead head = head_of(bytes);
  for (const KindRow& row : kKinds) {
    if (row.is_it != nullptr && row.is_it(head)) return &row.kind;
  }
  return nullptr;
}

const FileKind* kind_by_name(std::string_view name) {
  std::string lower(name.substr(name.rfind('/') + 1));
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  for (const KindRow& row : kKinds) {
    for (const std::string_view extension : split_words(row.extensions)) {
      if (lower.ends_with(extension)) return &row.kind;
    }
  }
  return nullptr;
}

std::optional<OtherKind> other_kind(std::string_view bytes, std::string_view name, FileUse wanted,
                                    bool is_recognised) {
  const FileKind* kind = kind_by_content(bytes);
  const FileKind* named = kind_by_name(name);
  const bool name_counts =
      (kind == nullptr && !is_recognised) || (kind != nullptr && kind->is_vague);
  if (name_counts && named != nullptr) kind = named;
  if (kind == nullptr || kind->use == wanted) return std::nullopt;
  if (bytes.empty()) return OtherKind{"it is empty", ""};
  const bool is_by_name = kind == named && name_counts;
  OtherKind other{fmt::format("{} {}", is_by_name ? "by its name it is" : "it is", kind->words),
                  ""};
  const std::string_view advice = advice_for(*kind, wanted);
  if (!advice.empty()) other.advice = ". " + with_name(advice, name);
  return other;
}

std::string other_kind_problem(std::string_view bytes, std::string_view name, FileUse wanted,
                               bool is_recognised) {
  const std::optional<OtherKind> other = other_kind(bytes, name, wanted, is_recognised);
  return other
             ? fmt::format("{}; {} is needed here{}", other->words, words_of(wanted), other->advice)
             : "";
}

bool check_file_kind(std::string_view bytes, const std::string& name, FileUse wanted,
                     Diagnostics& diagnostics, bool is_recognised) {
  const std::string problem = other_kind_problem(bytes, name, wanted, is_recognised);
  if (problem.empty()) return true;
  diagnostics.report(DiagnosticId::file_of_other_kind, SourceLocation{name, 0, 0}, problem);
  return false;
}

}  // namespace calc
