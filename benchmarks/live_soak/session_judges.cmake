# What judges a live session, whoever talks to it: the clients of live_soak, or the fuzz target.
add_library(session_judges STATIC ${CMAKE_CURRENT_LIST_DIR}/judge_reply.cpp
  ${CMAKE_CURRENT_LIST_DIR}/judge_session.cpp ${CMAKE_CURRENT_LIST_DIR}/random_request.cpp)
target_link_libraries(session_judges PUBLIC prehend_protocol)
