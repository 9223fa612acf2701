#pragma once
// Small IFC files for tests.

#include <string>

namespace test_support {

// With a project in these units (instances from #900 on, #905 is the plane angle) and these data.
inline std::string ifc_file(const std::string& data, const std::string& schema = "IFC4",
                            const std::string& length = "IFCSIUNIT(*,.LENGTHUNIT.,.MILLI.,.METRE.)",
                            const std::string& angle = "IFCSIUNIT(*,.PLANEANGLEUNIT.,$,.RADIAN.)") {
  return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n"
         "FILE_NAME('a','b',('c'),('d'),'pre','Hand 1.0','');\nFILE_SCHEMA(('" +
         schema + "'));\nENDSEC;\nDATA;\n#900=IFCPROJECT('p',$,'P',$,$,$,$,(),#901);\n" +
         "#901=IFCUNITASSIGNMENT((#902,#905));\n#902=" + length + ";\n#905=" + angle + ";\n" +
         data + "\nENDSEC;\nEND-ISO-10303-21;\n";
}

// A place that nothing changes (#800), and the direction up (#802).
inline std::string ifc_places() {
  return "#800=IFCLOCALPLACEMENT($,#801);#801=IFCAXIS2PLACEMENT3D(#803,$,$);"
         "#802=IFCDIRECTION((0.,0.,1.));#803=IFCCARTESIANPOINT((0.,0.,0.));";
}

// One space, #1, "101" "Office" at #800, of the body #10 that is given.
inline std::string ifc_space(const std::string& body) {
  return ifc_places() +
         "#1=IFCSPACE('room-a',$,'101',$,'office',#800,#2,'Office',.ELEMENT.,.SPACE.,$);"
         "#2=IFCPRODUCTDEFINITIONSHAPE($,$,(#3));"
         "#3=IFCSHAPEREPRESENTATION($,'Body','SweptSolid',(#10));" +
         body;
}

// #10, 3000 high, of the profile #11.
inline std::string ifc_extrusion(const std::string& profile) {
  return "#10=IFCEXTRUDEDAREASOLID(#11,$,#802,3000.);" + profile;
}

}  // namespace test_support
