#ifndef qFaceToBoneBrushPanel_h
#define qFaceToBoneBrushPanel_h

#include <QWidget>

#include <memory>

class QButtonGroup;
class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
namespace f2b
{
struct Brush;
} // namespace f2b

/// With which brush, how large and how strongly?
///
/// Knows no case and no node: the desktop's panel of the face and Slicer's module panel both hold one.
class qFaceToBoneBrushPanel : public QWidget
{
  Q_OBJECT

public:
  explicit qFaceToBoneBrushPanel(QWidget* parent = nullptr);
  ~qFaceToBoneBrushPanel() override;

  /// Without the plane of symmetry, which is the host's to find.
  const f2b::Brush& brush() const { return *m_brush; }
  /// Shows radius and strength that were changed in the 3D view.
  void setBrush(const f2b::Brush& brush);
  /// Whether a brush is chosen; else the mouse turns the view.
  bool isSculpting() const;
  /// No brush, when the host cannot sculpt any more.
  void stopSculpting();
  bool isSymmetric() const;
  /// Says beside "Both sides alike" whether the middle is known or only guessed from the skin.
  void setMiddleGuessed(bool guessed);

signals:
  void brushChanged();
  void sculptingChanged(bool on);

private:
  QWidget* makeBrushes();
  QWidget* makeSettings();
  void readControls();

  std::unique_ptr<f2b::Brush> m_brush;
  bool m_updating = false;
  QButtonGroup* m_kinds;
  QDoubleSpinBox *m_radius, *m_strength, *m_depth;
  QComboBox* m_curve;
  QCheckBox *m_symmetric, *m_frontOnly, *m_depthLimited;
};

#endif
