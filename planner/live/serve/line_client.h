// A client that talks in lines of text, without the network.
#pragma once

#include <string>
#include <string_view>

#include "planner/live/serve/connection.h"
#include "planner/live/serve/line_splitter.h"
#include "planner/live/serve/server_options.h"

namespace prehend {

// Makes messages of the bytes that come. `listener` and `token` outlive it.
class LineClient : public Connection {
 protected:
  LineClient(ConnectionContext ground, const LineListener& listener, const std::string& token)
      : Connection(std::move(ground)),
        listener_(listener),
        token_(token),
        splitter_(listener.largest_line) {}

  // From now on, or no more, the connection ends when the time of a handshake is over.
  virtual void limit_time() = 0;
  virtual void unlimit_time() = 0;

  // The client has come.
  void welcome();
  void use_bytes(std::string_view bytes);
  // It sends no more.
  void use_end();

 private:
  void use_line(std::string line, bool whole);
  void use_token(const std::string& shown);
  // `for_good`: the connection ends, and nothing that follows is carried out.
  void refuse(const std::string& problem, bool for_good);

  const LineListener& listener_;
  const std::string& token_;
  LineSplitter splitter_;
  bool shows_token_ = false;  // whether it has
  bool is_first_ = true;      // line, besides that with the token
};

}  // namespace prehend
