#include "planner/live/serve/http_rules.h"

#include <gtest/gtest.h>

namespace prehend {
namespace {

const HttpRules kRules{.token = "secret", .hosts = {"localhost", "127.0.0.1"}, .port = 8080};
const Pages kPages = {{"/", {"text/html", "start"}}, {"/more.js", {"text/javascript", "more"}}};

HttpRequest asked(std::string_view target) {
  return {.method = "GET", .target = target, .host = "127.0.0.1:8080", .origin = {}};
}

int status_of(const HttpRequest& request) { return answer_to(request, kRules, kPages).status; }

TEST(HttpRules, APageNeedsTheToken) {
  const HttpAnswer answer = answer_to(asked("/?token=secret"), kRules, kPages);
  ASSERT_EQ(answer.status, 200);
  EXPECT_EQ(answer.page->body, "start");
  EXPECT_FALSE(answer.upgrade);
  EXPECT_EQ(status_of(asked("/more.js?scene=mug&token=secret&token=wrong")), 200);
  for (const char* target : {"/", "/?", "/?token=", "/?token=secre", "/?token=secrets",
                             "/?token=wrong&token=secret", "/?xtoken=secret", "/more.js"}) {
    EXPECT_EQ(status_of(asked(target)), 403) << target;
  }
  HttpRules without = kRules;
  without.token = "";
  EXPECT_EQ(answer_to(asked("/?token="), without, kPages).status, 403);
}

TEST(HttpRules, NothingElseIsThere) {
  for (const char* target :
       {"/more?token=secret", "/../etc/passwd?token=secret", "//?token=secret", "*", "",
        "/%2e%2e/?token=secret", "http://127.0.0.1:8080/?token=secret", "/socket?token=secret"}) {
    EXPECT_EQ(status_of(asked(target)), 404) << target;
  }
}

TEST(HttpRules, PagesAreOnlyRead) {
  HttpRequest request = asked("/?token=secret");
  request.method = "HEAD";
  EXPECT_EQ(status_of(request), 200);
  for (const char* method : {"POST", "PUT", "OPTIONS", "DELETE", "get", ""}) {
    request.method = method;
    EXPECT_EQ(status_of(request), 405) << method;
  }
}

TEST(HttpRules, OnlyTheNamesOfThisServerAreAnswered) {
  HttpRequest request = asked("/?token=secret");
  for (const char* host : {"127.0.0.1:8080", "localhost:8080", "LocalHost:8080"}) {
    request.host = host;
    EXPECT_EQ(status_of(request), 200) << host;
  }
  for (const char* host : {"", "127.0.0.1", "127.0.0.1:80", "localhost:80800", "evil.com:8080",
                           "localhost.evil.com:8080", "evil.com", "127.0.0.1:8080 "}) {
    request.host = host;
    EXPECT_EQ(status_of(request), 403) << host;
  }
  // Browsers leave the port of HTTP out.
  HttpRules usual = kRules;
  usual.port = 80;
  request.host = "localhost";
  EXPECT_EQ(answer_to(request, usual, kPages).status, 200);
}

TEST(HttpRules, TheSocketIsForThePagesOfThisServerAndForPrograms) {
  HttpRequest request = asked("/socket?token=secret");
  request.is_upgrade = true;
  EXPECT_TRUE(answer_to(request, kRules, kPages).upgrade);
  for (const char* origin : {"http://127.0.0.1:8080", "http://localhost:8080"}) {
    request.origin = origin;
    EXPECT_TRUE(answer_to(request, kRules, kPages).upgrade) << origin;
  }
  for (const char* origin :
       {"", "null", "http://evil.com", "http://evil.com:8080", "https://127.0.0.1:8080",
        "http://127.0.0.1", "http://127.0.0.1:8081", "http://127.0.0.1:8080.evil.com", "file://"}) {
    request.origin = origin;
    EXPECT_EQ(status_of(request), 403) << origin;
    EXPECT_FALSE(answer_to(request, kRules, kPages).upgrade) << origin;
  }
  request.origin.reset();
  request.target = "/socket?token=wrong";
  EXPECT_EQ(status_of(request), 403);
  EXPECT_FALSE(answer_to(request, kRules, kPages).upgrade);
  request.target = "/?token=secret";
  EXPECT_FALSE(answer_to(request, kRules, kPages).upgrade);
}

TEST(HttpRules, WhatIsSaidTwiceIsNotGuessed) {
  HttpRequest request = asked("/?token=secret");
  EXPECT_EQ(status_of(request), 200);
  request.repeats = true;
  EXPECT_EQ(status_of(request), 400);
  request.target = "/socket?token=secret";
  request.is_upgrade = true;
  EXPECT_EQ(status_of(request), 400);
  EXPECT_FALSE(answer_to(request, kRules, kPages).upgrade);
}

}  // namespace
}  // namespace prehend
