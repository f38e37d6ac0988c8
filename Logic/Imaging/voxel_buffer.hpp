#pragma once

#include "Imaging/ct_image.hpp"

#include <itkImageIOBase.h>

#include <string>

/// How do a file's voxels become whole Hounsfield units?
namespace f2b
{

/// \throws Error  8-bit or colour voxels, which cannot be Hounsfield units
void require_hounsfield_type(const itk::ImageIOBase& io, const std::string& name);

/// Reads all voxels that `io` announces, rounded and limited to the range of short.
/// \throws Error  voxels that are NaN or infinite
void read_voxels(itk::ImageIOBase& io, const std::string& name, short* voxels);

/// Makes an image of that geometry with uninitialised voxels.
/// \throws Error  fewer than 16 voxels on an axis, a spacing or direction that no CT has
CtImage::Pointer make_image(const CtImage::SizeType& size, const CtImage::SpacingType& spacing,
                            const CtImage::PointType& origin,
                            const CtImage::DirectionType& direction, const std::string& name);

/// \throws Error  a spacing [mm] that is not a positive number
void require_spacing(const double* spacing, const std::string& name);

/// The first line with something in it of an ITK message, without its class and address.
std::string first_line(const std::string& message);

} // namespace f2b
