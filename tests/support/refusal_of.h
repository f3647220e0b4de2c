// The error with which a call refuses its input.
#pragma once

#include <gtest/gtest.h>

#include "sim/base/input_error.h"

namespace prehend::test {

// What `call` throws; a failure of the test where it throws nothing.
template <typename Call>
InputError refusal_of(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error;
  }
  ADD_FAILURE() << "nothing was refused";
  return InputError("nothing");
}

}  // namespace prehend::test
