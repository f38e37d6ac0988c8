#ifndef qFaceToBoneUnitSpin_h
#define qFaceToBoneUnitSpin_h

#include <QDoubleSpinBox>

/// A field for a number with its unit, to a tenth; it speaks when typing has ended.
inline QDoubleSpinBox* qFaceToBoneUnitSpin(double low, double high, double value,
                                           const QString& unit, double step = 1)
{
  auto* box = new QDoubleSpinBox;
  box->setRange(low, high);
  box->setDecimals(1);
  box->setSingleStep(step);
  box->setValue(value);
  box->setSuffix(" " + unit);
  box->setKeyboardTracking(false);
  box->setMinimumWidth(60); // else three of them are wider than the panel
  return box;
}

#endif
