#include "planner/show/report/report_html.h"

#include "planner/show/page/page_text.h"
#include "planner/show/report/report_json.h"

namespace prehend {

std::string report_html(const Report& report) {
  return page_with_data(report_page(), report_json(report));
}

}  // namespace prehend
