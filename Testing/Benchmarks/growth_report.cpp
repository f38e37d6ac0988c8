#include "Benchmarks/growth_report.hpp"

#include <cmath>
#include <fstream>
#include <iomanip>

namespace f2b::benchmarks
{
namespace
{

/// Slope of log y over log x by least squares.
double exponent(const std::vector<double>& x, const std::vector<double>& y)
{
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  const double n = static_cast<double>(x.size());
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    const double a = std::log(x[i]), b = std::log(y[i]);
    sx += a;
    sy += b;
    sxx += a * a;
    sxy += a * b;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

double counter(const benchmark::BenchmarkReporter::Run& run, const char* name)
{
  const auto found = run.counters.find(name);
  return found == run.counters.end() ? 0 : found->second.value;
}

} // namespace

void GrowthReport::ReportRuns(const std::vector<Run>& runs)
{
  ConsoleReporter::ReportRuns(runs);
  for (const Run& run : runs)
  {
    const double tets = counter(run, "tets");
    if (tets <= 0 || run.error_occurred)
      continue;
    const std::string name = run.benchmark_name();
    m_families[name.substr(0, name.find('/'))].push_back(
        {tets, run.real_accumulated_time / static_cast<double>(run.iterations),
         counter(run, "peak_MiB")});
  }
}

void GrowthReport::Finalize()
{
  ConsoleReporter::Finalize();
  std::ostream& out = GetOutputStream();
  for (const auto& [family, samples] : m_families)
  {
    print_ratios_to_peer(family);
    std::vector<double> tets, seconds, memory;
    for (const Sample& sample : samples)
    {
      tets.push_back(sample.tets);
      seconds.push_back(sample.seconds);
      memory.push_back(sample.mebibytes);
    }
    if (samples.size() < 2)
      continue;
    out << "growth of " << std::left << std::setw(22) << family << " time ~ tets^" << std::fixed
        << std::setprecision(2) << exponent(tets, seconds);
    if (memory.front() > 0)
      out << ", memory ~ tets^" << exponent(tets, memory);
    out << "\n";
  }
}

void GrowthReport::print_ratios_to_peer(const std::string& family)
{
  const std::size_t by = family.find("_by_");
  const auto own = m_families.find(family.substr(0, by));
  if (by == std::string::npos || own == m_families.end())
    return;
  for (const Sample& peer : m_families[family])
    for (const Sample& sample : own->second)
      if (sample.tets == peer.tets)
        GetOutputStream() << own->first << " of " << std::fixed << std::setprecision(0)
                          << sample.tets << " tets: " << std::setprecision(1)
                          << peer.seconds / sample.seconds << " times faster than by "
                          << family.substr(by + 4) << "\n";
}

void reset_peak_memory()
{
  std::ofstream("/proc/self/clear_refs") << "5";
}

double peak_memory_mib()
{
  std::ifstream status("/proc/self/status");
  std::string word;
  double kibibytes = 0;
  while (status >> word)
    if (word == "VmHWM:")
      status >> kibibytes;
  return kibibytes / 1024;
}

} // namespace f2b::benchmarks
