/// Where the time of a frame goes, as a bench.
#ifndef BALLOON_SHOW_BENCH_FRAME_H
#define BALLOON_SHOW_BENCH_FRAME_H

#include "lab/bench/bench.h"

extern const BenchCase bench_frame;

#endif
