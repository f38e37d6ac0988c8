#ifndef qFaceToBoneSculptPanel_h
#define qFaceToBoneSculptPanel_h

#include <QWidget>

#include <memory>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class qFaceToBoneBrushPanel;
class qFaceToBoneCase;
namespace f2b
{
struct Brush;
} // namespace f2b

/// With what, how large and how strongly is the face sculpted?
///
/// Brushes and their settings, moving a landmark by numbers, the mask, the target's files.
class qFaceToBoneSculptPanel : public QWidget
{
  Q_OBJECT

public:
  qFaceToBoneSculptPanel(qFaceToBoneCase* work, QWidget* parent = nullptr);
  ~qFaceToBoneSculptPanel() override;

  const f2b::Brush& brush() const { return *m_brush; }
  /// Shows a brush that was changed in the 3D view.
  void setBrush(const f2b::Brush& brush);
  bool isSculpting() const;
  /// Whether landmarks of the face are to be handles that drag it, how far, and on both sides alike.
  bool showsHandles() const;
  double warpRadius() const;
  bool isSymmetric() const;

signals:
  void brushChanged();
  void sculptingChanged(bool on);
  void handlesShown(bool on);

private:
  QWidget* makeLandmarkMove();
  QWidget* makeMaskAndFiles();
  void readControls();
  void moveLandmark();
  void updateLandmarks();

  qFaceToBoneCase* m_case;
  std::unique_ptr<f2b::Brush> m_brush;
  qFaceToBoneBrushPanel* m_brushes;
  QCheckBox* m_handles;
  QComboBox* m_landmark;
  QDoubleSpinBox *m_move[3], *m_moveRadius;
};

#endif
