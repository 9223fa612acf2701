#include "report/shell/output/pdf_places.h"

// The pointers of today's qpdf; without it the header warns.
#define POINTERHOLDER_TRANSITION 4
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>

#include <exception>
#include <map>

namespace cli {

std::map<std::string, int> places_in_pdf(const std::string& pdf) {
  std::map<std::string, int> places;
  try {
    QPDF file;
    file.setSuppressWarnings(true);
    file.processMemoryFile("report", pdf.data(), pdf.size());
    std::map<QPDFObjGen, int> number_of_page;
    int number = 0;
    for (QPDFPageObjectHelper& page : QPDFPageDocumentHelper(file).getAllPages())
      number_of_page[page.getObjectHandle().getObjGen()] = ++number;
    QPDFObjectHandle targets = file.getRoot().getKey("/Dests");
    if (!targets.isDictionary()) return {};
    for (const std::string& name : targets.getKeys()) {
      QPDFObjectHandle target = targets.getKey(name);
      if (!target.isArray() || target.getArrayNItems() == 0) continue;
      const auto page = number_of_page.find(target.getArrayItem(0).getObjGen());
      if (page != number_of_page.end()) places[name.substr(1)] = page->second;  // "/name"
    }
  } catch (const std::exception&) {
    return {};  // the report is whole without page numbers in its contents
  }
  return places;
}

}  // namespace cli
