# Learning needs xgboost (.ci/packages-learn), and nothing else of prehend does: without it all is
# built, and `prehend learn` says what to install. Not one of the rooms, so that the shared library
# does without it in any case.
find_path(XGBOOST_INCLUDE_DIR xgboost/c_api.h)
find_library(XGBOOST_LIBRARY NAMES xgboost libxgboost.so.0)
add_library(prehend_train STATIC planner/bulk/train/data_sets.cpp
  planner/bulk/train/train_order.cpp)
target_link_libraries(prehend_train PUBLIC prehend_datasets PRIVATE nlohmann_json::nlohmann_json)
if(XGBOOST_INCLUDE_DIR AND XGBOOST_LIBRARY)
  target_sources(prehend_train PRIVATE planner/bulk/train/boost_with_xgboost.cpp)
  target_include_directories(prehend_train SYSTEM PRIVATE ${XGBOOST_INCLUDE_DIR})
  target_link_libraries(prehend_train PRIVATE ${XGBOOST_LIBRARY})
else()
  target_sources(prehend_train PRIVATE planner/bulk/train/boost_without_xgboost.cpp)
endif()
