/// A bench of the stages of a frame.
#ifndef BALLOON_SHOW_BENCH_FRAME_H
#define BALLOON_SHOW_BENCH_FRAME_H

#include "lab/bench/bench.h"

extern const BenchCase bench_frame;

#endif
