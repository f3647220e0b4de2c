// Times and sizes of memory as Slurm's options have them.
#pragma once

#include <string>

namespace prehend {

// Seconds of MINUTES, MINUTES:SECONDS, HOURS:MINUTES:SECONDS, DAYS-HOURS, DAYS-HOURS:MINUTES or
// DAYS-HOURS:MINUTES:SECONDS. Throws InputError without a field for other words, for 0 and for more
// than a year.
int slurm_seconds(const std::string& words);

// Megabytes of a whole number with K, M, G or T behind it, or M if nothing is; K is rounded up.
// Throws InputError without a field for other words, for 0 and for more than 1000 T.
int slurm_megabytes(const std::string& words);

}  // namespace prehend
