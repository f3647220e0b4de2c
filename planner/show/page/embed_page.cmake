# Run by page.cmake as a script: PAGE_DIR, SHARED_DIR, THREE_SCRIPTS (a list), FUNCTION, OUTPUT.
file(READ ${PAGE_DIR}/page.html page)
file(READ ${PAGE_DIR}/page.css style)
set(three "")
foreach(script IN LISTS THREE_SCRIPTS)
  file(READ ${script} text)
  string(APPEND three "${text}\n")
endforeach()

# First the page's data, which all scripts use, then those of all pages and those of this one in the
# order of their names, last main.js, which uses them all.
file(GLOB shared_scripts ${SHARED_DIR}/*.js)
file(GLOB own_scripts ${PAGE_DIR}/*.js)
list(REMOVE_ITEM own_scripts ${PAGE_DIR}/data.js ${PAGE_DIR}/main.js)
set(script_text "")
foreach(script IN LISTS shared_scripts own_scripts)
  file(READ ${script} text)
  string(APPEND script_text "${text}\n")
endforeach()
file(READ ${PAGE_DIR}/data.js data_text)
file(READ ${PAGE_DIR}/main.js main_text)
set(script_text "${data_text}\n${script_text}${main_text}")

string(REPLACE "/*STYLE*/" "${style}" page "${page}")
string(REPLACE "/*THREE*/" "${three}" page "${page}")
string(REPLACE "/*SCRIPT*/" "${script_text}" page "${page}")
file(WRITE ${OUTPUT} "#include <string_view>

namespace prehend {

std::string_view ${FUNCTION}();

std::string_view ${FUNCTION}() {
  return R\"prehend_page(${page})prehend_page\";
}

}  // namespace prehend
")
