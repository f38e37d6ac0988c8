#pragma once

#include <Bridge/json_file.hpp>
#include <Case/verbs.hpp>

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <filesystem>

#include <unistd.h>

/// The patient of the window's tests, made once for a test program.
namespace f2b::testing
{

/// A folder for the program's own files, gone with it; or, where FACETOBONE_TEST_PATIENT names one
/// that an unsanitized program has filled, that one: under sanitizers the making takes half an hour.
struct PatientFolder
{
  explicit PatientFolder(const std::string& name)
      : given(std::getenv("FACETOBONE_TEST_PATIENT")),
        folder(given ? std::filesystem::path(given) / name
                     : std::filesystem::temp_directory_path() /
                           ("f2b desktop " + name + " " + std::to_string(::getpid())))
  {
  }
  ~PatientFolder()
  {
    if (!given)
      std::filesystem::remove_all(folder);
  }
  const char* given;
  std::filesystem::path folder;
};

/// The virtual patient, coarse; made once for the program.
struct CoarsePatient : PatientFolder
{
  CoarsePatient() : PatientFolder("patient")
  {
    if (given)
      return;
    SampleOptions options;
    options.spacing_mm = 1;
    write_sample(folder, options, no_progress);
    nlohmann::json document = read_json(folder / "case.json");
    document["mesh"]["density"] = 0.15;
    document["solver"]["max_fit_iterations"] = 2;
    write_json(folder / "case.json", document);
  }
};

inline const CoarsePatient& coarse_patient()
{
  static const CoarsePatient patient;
  return patient;
}

/// The same after its first step.
struct SegmentedPatient : PatientFolder
{
  SegmentedPatient() : PatientFolder("segmented")
  {
    if (given)
      return;
    const auto file = coarse_patient().folder / "case.json";
    CaseSession session(folder, read_json(file), file);
    segment_case(session);
  }
};

inline const SegmentedPatient& segmented_patient()
{
  static const SegmentedPatient patient;
  return patient;
}

} // namespace f2b::testing
