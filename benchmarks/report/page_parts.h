// The parts of the page, each from its entries. They add nothing where there are none.
#pragma once

#include "benchmarks/report/page_writer.h"
#include "benchmarks/report/results.h"

namespace prehend::bench {

void add_kernels(const Results& results, PageWriter& page);
void add_trials(const Results& results, PageWriter& page);
void add_plans(const Results& results, PageWriter& page);
void add_trade(const Results& results, PageWriter& page);
void add_scaling(const Results& results, PageWriter& page);
void add_peers(const Results& results, PageWriter& page);

}  // namespace prehend::bench
