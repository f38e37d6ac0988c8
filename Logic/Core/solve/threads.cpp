#include "Core/solve/threads.hpp"

#include <omp.h>

// OpenBLAS has no header for this in every package; another BLAS does not have the function.
extern "C" void openblas_set_num_threads(int) __attribute__((weak));

namespace f2b
{

void set_thread_count(int threads)
{
  omp_set_num_threads(threads);
  if (openblas_set_num_threads)
    openblas_set_num_threads(threads);
}

} // namespace f2b
