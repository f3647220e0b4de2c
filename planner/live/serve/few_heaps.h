// Memory of a process that serves for days.
#pragma once

namespace prehend {

// Makes all threads that begin from now on allocate from few heaps. By default the C library gives
// each of the first threads a heap of its own, eight a core: what one thread has freed is then no
// use to the others, and the process grows with every thread that ever did something large. For
// programs that live long, at their start; one that computes with all its cores would wait here.
void use_few_heaps();

}  // namespace prehend
