#pragma once

#include <Bridge/json_file.hpp>
#include <Case/verbs.hpp>

#include <nlohmann/json.hpp>

#include <filesystem>

#include <unistd.h>

/// The patient of the window's tests, made once for a test program.
namespace f2b::testing
{

/// The virtual patient, coarse; made once for the program, gone with it.
struct CoarsePatient
{
  CoarsePatient()
      : folder(std::filesystem::temp_directory_path() /
               ("f2b desktop patient " + std::to_string(::getpid())))
  {
    SampleOptions options;
    options.spacing_mm = 1;
    write_sample(folder, options, no_progress);
    nlohmann::json document = read_json(folder / "case.json");
    document["mesh"]["density"] = 0.15;
    document["solver"]["max_fit_iterations"] = 2;
    write_json(folder / "case.json", document);
  }
  ~CoarsePatient() { std::filesystem::remove_all(folder); }
  std::filesystem::path folder;
};

inline const CoarsePatient& coarse_patient()
{
  static const CoarsePatient patient;
  return patient;
}

/// The same after its first step.
struct SegmentedPatient
{
  SegmentedPatient()
      : folder(std::filesystem::temp_directory_path() /
               ("f2b desktop segmented " + std::to_string(::getpid())))
  {
    const auto file = coarse_patient().folder / "case.json";
    CaseSession session(folder, read_json(file), file);
    segment_case(session);
  }
  ~SegmentedPatient() { std::filesystem::remove_all(folder); }
  std::filesystem::path folder;
};

inline const SegmentedPatient& segmented_patient()
{
  static const SegmentedPatient patient;
  return patient;
}

} // namespace f2b::testing
