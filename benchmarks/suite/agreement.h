// How far the same candidates come out the same at two settings.
#pragma once

#include <vector>

namespace prehend::bench {

// Indices of the `count` largest values above 0, largest first; of equal ones, the smaller index.
std::vector<std::size_t> best_of(const std::vector<double>& values, std::size_t count);

// Of the `wanted` best of `reference`, how many are among the `allowed` best of `values`. Values
// are ε of the same candidates in both, 0 where a grasp does not hold.
std::size_t kept_of_best(const std::vector<double>& reference, const std::vector<double>& values,
                         std::size_t wanted, std::size_t allowed);

// |value - reference| / reference of those above 0 in both [%].
std::vector<double> relative_errors(const std::vector<double>& reference,
                                    const std::vector<double>& values);

// Of all, how many are above 0 in one of the two only [%].
double other_verdicts(const std::vector<double>& reference, const std::vector<double>& values);

}  // namespace prehend::bench
