// What is measured? Each part prints its own tables, and adds its results to the report. None depends on what
// ran before it.
#pragma once

#include "report.h"

namespace halfdisk {

/// Short runs only show that the benchmark works.
enum class Effort { quick, full };

/// Closest and any hits, one by one, in batches and in fans, beside Embree and Box2D, and checked.
void benchIndex(Report& report, Effort effort);

/// Time to build the index and its size beside Embree's, and to build it again when one wall has moved.
void benchBuild(Report& report, Effort effort);

/// Rays per second of every estimator on every scene of the lessons.
void benchEstimators(Report& report, Effort effort);

/// Wall time of castRay, paths, light and photons on two threads and on all, against one.
void benchThreads(Report& report, Effort effort);

/// Time from the call until work ends that is called off, for every estimator.
void benchCancel(Report& report, Effort effort);

/// Time to draw a flight of light into a field, for several sizes and ways.
void benchSplat(Report& report, Effort effort);

/// Time per ray of castRay beyond the index.
void benchOverhead(Report& report, Effort effort);

/// castRay with NoObserver against the same source without its observer, in turns within one process.
void benchObserver(Report& report, Effort effort);

/// CPU time of the frame function, the light's thread and the software GL left out, while P is dragged along
/// the walls of each lesson's scene with N = 64 and maxDepth = 2.
void benchFrame(Report& report, Effort effort);

/// Wall time from a change of the seed until the first answer, and until the first picture of each kind, at
/// every step of every lesson.
void benchFirst(Report& report, Effort effort);

}  // namespace halfdisk
