#ifndef __vtkMRMLFaceToBonePlannedMovement_h
#define __vtkMRMLFaceToBonePlannedMovement_h

#include "vtkMRMLFaceToBoneOptional.h"

/// What does a plan say of one fragment's movement?
struct vtkMRMLFaceToBonePlannedMovement
{
  std::string Fragment;
  vtkMRMLFaceToBoneOptional<6> Movement; ///< right, anterior, superior [mm], pitch, roll, yaw [deg]
  vtkMRMLFaceToBoneOptional<3> Reference;    ///< the point that shifts are of, RAS [mm]
  vtkMRMLFaceToBoneOptional<2> Intervals[6]; ///< of each coordinate

  /// The value of an XML attribute: a list of `key=value`.
  std::string ToText() const;
  static vtkMRMLFaceToBonePlannedMovement FromText(const std::string& text);
};

#endif
