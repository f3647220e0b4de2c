// The page of a live session, which a server gives to browsers. All that it shows and does goes
// over the protocol (docs/reference/protocol.md).
#pragma once

#include <string>
#include <string_view>

namespace prehend {

struct StudioPage {
  std::string html;
  // What the page may do, for the header of this name: run its own scripts, which show `nonce`, and
  // talk to the server that it came from. Whatever else a name or a file could smuggle into it is
  // not run and not loaded.
  std::string content_security_policy;
};

// `nonce`: letters, digits, "-" and "_" that nobody can guess, new for each server.
StudioPage studio_page(std::string_view nonce);

}  // namespace prehend
