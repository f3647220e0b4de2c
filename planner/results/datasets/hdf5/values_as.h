// Values of a data set as numbers and texts.
#pragma once

#include <string>
#include <vector>

#include "planner/results/datasets/hdf5/data_set.h"

namespace prehend::hdf5 {

// One number of each value; T is double, float or std::int64_t. The bytes are those of raw_values,
// the type is whole or a flag, or, for double and float, real. Throws InputError for a whole number
// that T cannot hold.
template <typename T>
std::vector<T> numbers_of(const ValueType& type, Bytes values);

// One text of each value, up to a byte 0 or to the padding. Throws InputError for too long texts.
std::vector<std::string> texts_of(const Image& image, const ValueType& type, Bytes values);

}  // namespace prehend::hdf5
