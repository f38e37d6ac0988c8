#ifndef qFaceToBoneRules_h
#define qFaceToBoneRules_h

#include <QString>

#include <nlohmann/json_fwd.hpp>

#include <array>

/// What may a fragment's coordinate do? [mm or degrees]
struct qFaceToBoneRule
{
  bool locked = false; ///< it stays at 0
  bool bounded = false;
  double least = 0, most = 0; ///< where bounded
};

/// Right, anterior, superior, pitch, roll, yaw: in the order of qFaceToBoneCase::Movement.
struct qFaceToBoneRules
{
  std::array<qFaceToBoneRule, 6> coordinates;
  QString restraint; ///< why no coordinate can be moved by hand (a hinge, a bite); empty: they can

  bool isLocked(std::size_t k) const { return !restraint.isEmpty() || coordinates[k].locked; }
  /// The value nearest to a wish that the rule allows; `most` either way where there is none.
  double within(std::size_t k, double wish, double most) const;
};

/// The rules of a case file's `movement`, and that with one of them changed: a locked coordinate
/// has no bounds and no prior.
qFaceToBoneRules qFaceToBoneRulesFrom(const nlohmann::json& movement);
nlohmann::json qFaceToBoneWithRule(nlohmann::json movement, std::size_t coordinate,
                                   const qFaceToBoneRule& rule);

#endif
