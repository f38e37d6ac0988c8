#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <vector>

/// How do time and memory grow with the number of tetrahedra?
namespace f2b::benchmarks
{

/// Prints every run as google-benchmark does, and at the end, for each family of runs over several
/// sizes, the exponent p of the least-squares fit value ~ size^p.
///
/// A run belongs to a family by its name up to the first '/', and takes part if it has a counter
/// `tets`; a counter `peak_MiB` is fitted besides its time. A family `F_by_P` is a peer P's way of
/// doing F: where both ran at one size, the ratio of their times is printed.
class GrowthReport : public benchmark::ConsoleReporter
{
public:
  void ReportRuns(const std::vector<Run>& runs) override;
  void Finalize() override;

private:
  struct Sample
  {
    double tets, seconds, mebibytes;
  };
  void print_ratios_to_peer(const std::string& family);

  std::map<std::string, std::vector<Sample>> m_families;
};

/// Forgets the process's peak of resident memory, so that the next reading is of what follows.
void reset_peak_memory();
/// Peak of resident memory since the last reset [MiB].
double peak_memory_mib();

} // namespace f2b::benchmarks
