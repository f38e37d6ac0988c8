#include "Core/material/law_variation.hpp"

namespace f2b
{
namespace
{

void stiffen(IsochoricNeoHookean& law, double factor)
{
  law.c10 *= factor;
}
void stiffen(IsochoricMooneyRivlin& law, double factor)
{
  law.c10 *= factor;
  law.c01 *= factor;
}
void stiffen(IsochoricYeoh& law, double factor)
{
  law.c1 *= factor;
  law.c2 *= factor;
  law.c3 *= factor;
}
void stiffen(LinearElastic& law, double factor)
{
  law.shear_modulus *= factor;
  law.bulk_modulus *= factor;
}
template <class Isochoric>
void stiffen(Hyperelastic<Isochoric>& law, double factor)
{
  stiffen(law.isochoric, factor);
  law.volumetric.bulk_modulus *= factor;
}

void set_bulk_modulus(LinearElastic& law, double bulk_modulus)
{
  law.bulk_modulus = bulk_modulus;
}
template <class Isochoric>
void set_bulk_modulus(Hyperelastic<Isochoric>& law, double bulk_modulus)
{
  law.volumetric.bulk_modulus = bulk_modulus;
}

} // namespace

Law stiffened(const Law& law, double factor)
{
  Law result = law;
  std::visit([=](auto& l) { stiffen(l, factor); }, result);
  return result;
}

Law with_poisson_ratio(const Law& law, double poisson_ratio)
{
  Law result = law;
  const double bulk_modulus = bulk_from(shear_modulus(law), poisson_ratio);
  std::visit([=](auto& l) { set_bulk_modulus(l, bulk_modulus); }, result);
  return result;
}

} // namespace f2b
