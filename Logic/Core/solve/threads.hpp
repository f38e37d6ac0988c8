#pragma once

namespace f2b
{

/// Limits assembly (OpenMP) and factorisation (OpenBLAS) to so many threads.
void set_thread_count(int threads);

} // namespace f2b
