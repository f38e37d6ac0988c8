#ifndef qFaceToBoneCutsPanel_h
#define qFaceToBoneCutsPanel_h

#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QSlider;
class qFaceToBoneCase;

/// Where is the bone cut, how wide, and how finely is the tissue meshed?
class qFaceToBoneCutsPanel : public QWidget
{
  Q_OBJECT

public:
  qFaceToBoneCutsPanel(qFaceToBoneCase* work, QWidget* parent = nullptr);

  bool showsPlanes() const;

signals:
  void planesShown(bool on);
  /// A plane is wanted where the crosshair is.
  void planeWanted();
  /// Fragments are to be drawn apart by so much [mm].
  void explodeChanged(double mm);

private:
  void update();

  qFaceToBoneCase* m_case;
  QCheckBox* m_planes;
  QComboBox* m_template;
  QDoubleSpinBox *m_kerf, *m_density;
  QSlider* m_explode;
  QLabel* m_fragments;
};

#endif
