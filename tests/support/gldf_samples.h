#pragma once
// Small GLDF containers.

#include "tests/support/photometry_samples.h"
#include "tests/support/zip_bytes.h"

#include <string>

namespace test_support {

// Parts of product.xml; the text of each group as it stands between its tags.
struct GldfSample {
  std::string files =
      "<File id='f1' contentType='ldc/eulumdat' type='localFileName'>a.ldt</File>"
      "<File id='f2' contentType='ldc/ies' type='localFileName'>b.ies</File>";
  std::string photometries =
      "<Photometry id='p1'><PhotometryFileReference fileId='f1'/></Photometry>"
      "<Photometry id='p2'><PhotometryFileReference fileId='f2'/></Photometry>";
  std::string light_sources, equipment;
  std::string emitters =
      "<Emitter id='e1'><ChangeableLightEmitter><PhotometryReference photometryId='p1'/>"
      "</ChangeableLightEmitter></Emitter>";
  std::string variants =
      "<Variant id='v1'><Name><Locale language='de'>Eins</Locale>"
      "<Locale language='en'>One</Locale></Name><Geometry><EmitterReference emitterId='e1'/>"
      "</Geometry></Variant>";
};

// One group a line: files in line 2, photometries 3, light sources 4, equipment 5, emitters 6,
// variants 7.
inline std::string product_xml(const GldfSample& sample) {
  return "\xEF\xBB\xBF<Root><Header><Manufacturer>luxgate examples</Manufacturer></Header>"
         "<GeneralDefinitions><Files>\n" +
         sample.files + "</Files><Photometries>\n" + sample.photometries +
         "</Photometries><LightSources>\n" + sample.light_sources +
         "</LightSources><Equipments>\n" + sample.equipment + "</Equipments><Emitters>\n" +
         sample.emitters +
         "</Emitters></GeneralDefinitions><ProductDefinitions><ProductMetaData><Name>"
         "<Locale language='en'>Lamp</Locale></Name></ProductMetaData><Variants>\n" +
         sample.variants + "</Variants></ProductDefinitions></Root>";
}

// With ldc/a.ldt (1000 lm of lamps, ratio 1, 10 W) and ldc/b.ies (100 cd, 1000 lm of lamps).
inline std::string gldf_bytes(const GldfSample& sample, LdtSample ldt = {}) {
  return zip_bytes({{"product.xml", product_xml(sample)},
                    {"ldc/a.ldt", ldt_text(ldt)},
                    {"ldc/b.ies", ies_text({})}});
}

}  // namespace test_support
