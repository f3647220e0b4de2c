# Run by page.cmake as a script: PAGE_DIR, THREE_SCRIPTS (a list), OUTPUT.
file(READ ${PAGE_DIR}/page.html page)
file(READ ${PAGE_DIR}/page.css style)
set(three "")
foreach(script IN LISTS THREE_SCRIPTS)
  file(READ ${script} text)
  string(APPEND three "${text}\n")
endforeach()

# In the order of their names, but for main.js, which uses them all.
file(GLOB scripts ${PAGE_DIR}/*.js)
list(REMOVE_ITEM scripts ${PAGE_DIR}/main.js)
set(script_text "")
foreach(script IN LISTS scripts)
  file(READ ${script} text)
  string(APPEND script_text "${text}\n")
endforeach()
file(READ ${PAGE_DIR}/main.js text)
string(APPEND script_text "${text}")

string(REPLACE "/*STYLE*/" "${style}" page "${page}")
string(REPLACE "/*THREE*/" "${three}" page "${page}")
string(REPLACE "/*SCRIPT*/" "${script_text}" page "${page}")

string(FIND "${page}" "/*DATA*/" at)
if(at EQUAL -1)
  message(FATAL_ERROR "page.html: no place for the data")
endif()
string(SUBSTRING "${page}" 0 ${at} before)
math(EXPR after_at "${at} + 8")
string(SUBSTRING "${page}" ${after_at} -1 after)
file(WRITE ${OUTPUT} "#include \"planner/report/report_html.h\"

namespace prehend {

std::string_view page_before_data() {
  return R\"prehend_page(${before})prehend_page\";
}

std::string_view page_after_data() {
  return R\"prehend_page(${after})prehend_page\";
}

}  // namespace prehend
")
