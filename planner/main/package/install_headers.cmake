# Run by `cmake --install`, with the variables `source` (folder), `pages` (headers in it), `written`
# (a folder to write to) and `destination` (below the prefix). Installs each page as prehend/NAME.h,
# and every header that it includes, directly or not, under prehend/ with its path.
# In the source tree these include each other as "sim/...", which needs the tree on the include path;
# installed they say <prehend/sim/...>.

cmake_minimum_required(VERSION 3.25)

# Headers that are installed at the top, where a user includes them from.
set(contents_pages sim/quality/quality.h planner/prehend.h planner/simulation.h planner/contacts.h)

function(install_path header result)
  set(path prehend/${header})
  if(header IN_LIST contents_pages)
    cmake_path(GET header FILENAME name)
    set(path prehend/${name})
  endif()
  set(${result} ${path} PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${written})
set(waiting ${pages})
set(known ${pages})
while(waiting)
  list(POP_FRONT waiting header)
  file(READ ${source}/${header} text)
  string(REGEX MATCHALL "#include \"[^\"]+\"" includes "${text}")
  foreach(line IN LISTS includes)
    string(REGEX REPLACE "#include \"(.*)\"" "\\1" included "${line}")
    install_path(${included} path)
    string(REPLACE "${line}" "#include <${path}>" text "${text}")
    if(NOT included IN_LIST known)
      list(APPEND known ${included})
      list(APPEND waiting ${included})
    endif()
  endforeach()
  install_path(${header} path)
  file(WRITE ${written}/${path} "${text}")
endwhile()
file(INSTALL DESTINATION "${CMAKE_INSTALL_PREFIX}/${destination}" TYPE DIRECTORY
  FILES ${written}/prehend)
