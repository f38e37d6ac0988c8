#include "Imaging/moved_ct.hpp"

namespace f2b
{

CtImage::Pointer moved_ct(const CtImage& ct, const RigidMotion& motion)
{
  const Vec3 lps(-1, -1, 1); // times RAS, and back
  const Mat3 rotation = lps.asDiagonal() * motion.rotation * lps.asDiagonal();
  const Vec3 origin = lps.cwiseProduct(motion.apply(
      lps.cwiseProduct(Vec3(ct.GetOrigin()[0], ct.GetOrigin()[1], ct.GetOrigin()[2]))));
  CtImage::DirectionType direction;
  CtImage::PointType first;
  for (unsigned row = 0; row < 3; ++row)
  {
    first[row] = origin[row];
    for (unsigned column = 0; column < 3; ++column)
    {
      direction(row, column) = 0;
      for (unsigned k = 0; k < 3; ++k)
        direction(row, column) += rotation(row, k) * ct.GetDirection()(k, column);
    }
  }
  auto moved = CtImage::New();
  moved->Graft(&ct);
  moved->SetOrigin(first);
  moved->SetDirection(direction);
  return moved;
}

} // namespace f2b
