// The secret that a client shows.
#pragma once

#include <string>
#include <string_view>

namespace prehend {

// 128 bits from the operating system, as 32 hexadecimal digits. Throws std::system_error where it
// has none.
std::string random_token();

// Whether both are equal, in a time that depends on their lengths only: how long a wrong guess
// takes does not tell how much of it was right.
bool same_secret(std::string_view one, std::string_view other);

}  // namespace prehend
