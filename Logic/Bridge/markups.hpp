#pragma once

#include "Core/geometry/osteotomy_templates.hpp"

#include <filesystem>

/// How do landmarks, curves and planes travel between Slicer and us? Slicer markups, `.mrk.json`.
///
/// Files are written in LPS, as Slicer writes them; either frame is read. Positions here are RAS
/// [mm].
namespace f2b
{

struct ControlPoint
{
  std::string label;
  Vec3 position = Vec3::Zero();
};

/// One Fiducial, Line, Angle, Curve or ClosedCurve markup.
struct PointMarkup
{
  std::string type = "Fiducial";
  std::vector<ControlPoint> points;
};

/// The first markup of a file. Throws Error on other types, missing or non-finite positions.
PointMarkup read_points(const std::filesystem::path& path);
void write_points(const std::filesystem::path& path, const PointMarkup& markup);
/// All of a file's markups, which are none of them planes.
std::vector<PointMarkup> read_point_markups(const std::filesystem::path& path);
void write_point_markups(const std::filesystem::path& path,
                         const std::vector<PointMarkup>& markups);

/// The labelled points of a Fiducial file, which may hold none yet; a label that appears twice is
/// refused.
Landmarks read_landmarks(const std::filesystem::path& path);
void write_landmarks(const std::filesystem::path& path, const Landmarks& landmarks);

/// Every plane of a file; its name, or its file's name where it has none.
std::vector<BoundedPlane> read_planes(const std::filesystem::path& path);
void write_planes(const std::filesystem::path& path, const std::vector<BoundedPlane>& planes);

} // namespace f2b
